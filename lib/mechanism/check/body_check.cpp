#include "mechanism/check/body_check.hpp"

namespace kinestat {

void check_bodies(const SectionContext& context) {
  for (const BodyDescription& body : context.description.bodies) {
    for (const PointDescription& point : body.outline) {
      context.point(point);
    }
  }
}

}  // namespace kinestat
