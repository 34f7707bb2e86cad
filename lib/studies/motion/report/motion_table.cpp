#include "studies/motion/report/motion_table.hpp"

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

}  // namespace kinestat
