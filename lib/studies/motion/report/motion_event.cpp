#include "studies/motion/report/motion_event.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion_tolerance.hpp"

namespace kinestat {

bool MotionEvent::is_jump_of(std::size_t column) const {
  const std::optional<double> from = value_before(column);
  const std::optional<double> to = value_after(column);
  if (!from || !to) {
    return from || to;
  }
  return std::abs(*to - *from) > kJump * std::max(std::abs(*from), std::abs(*to));
}

}  // namespace kinestat
