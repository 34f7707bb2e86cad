#include "report/plane_json.hpp"

namespace kinestat {

Json PlaneJson::circle(const Circle& circle) const {
  Json result = object_of(2);
  result["centre"] = point(circle.centre);
  result["radius"] = length(circle.radius);
  return result;
}

}  // namespace kinestat
