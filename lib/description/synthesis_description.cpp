#include "description/synthesis_description.hpp"

namespace kinestat {

int PositionDescription::order() const {
  if (!derivatives.empty()) {
    return 1 + static_cast<int>(derivatives.size());
  }
  return 1 + (pole ? 1 : 0) + (curvature ? 1 : 0) + (stationary ? 1 : 0) + (burmester ? 1 : 0);
}

}  // namespace kinestat
