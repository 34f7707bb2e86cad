#include "studies/motion/report/motion_extremes.hpp"

namespace kinestat {

std::vector<const MotionValues*> all_values(const MotionTable& motion) {
  std::vector<const MotionValues*> all;
  for (const MotionRow& row : motion.rows) {
    all.push_back(&row.values);
  }
  for (const MotionEvent& event : motion.events) {
    if (!event.places.empty()) {
      all.push_back(&event.places);
    }
  }
  return all;
}

MotionExtremes find_extremes(const std::vector<const MotionValues*>& values, std::size_t column) {
  MotionExtremes found;
  for (const MotionValues* one : values) {
    const std::optional<double>& value = (*one)[column];
    if (value && (found.least == nullptr || *value < *(*found.least)[column])) {
      found.least = one;
    }
    if (value && (found.greatest == nullptr || *value > *(*found.greatest)[column])) {
      found.greatest = one;
    }
  }
  return found;
}

}  // namespace kinestat
