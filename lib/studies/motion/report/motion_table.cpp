#include "studies/motion/report/motion_table.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion_tolerance.hpp"

namespace kinestat {

std::string_view word_of(MotionEnd end) {
  switch (end) {
    case MotionEnd::complete:
      return "complete";
    case MotionEnd::limited:
      return "limited";
    case MotionEnd::drives_locked:
      return "locked";
    case MotionEnd::lost:
      return "lost";
    case MotionEnd::not_assembled:
      return "not_assembled";
  }
  return "";
}

bool MotionEvent::is_jump_of(std::size_t column) const {
  const std::optional<double> from = value_before(column);
  const std::optional<double> to = value_after(column);
  if (!from || !to) {
    return from || to;
  }
  return std::abs(*to - *from) > kJump * std::max(std::abs(*from), std::abs(*to));
}

}  // namespace kinestat
