#include "studies/motion/lanes/lane_means.hpp"

#include <numeric>

#include "core/index.hpp"

namespace kinestat {

LaneMeans::LaneMeans(const LaneQuestion& question)
    : values_(question.places.size()), means_(question.places.size()) {
  const std::size_t positions = at(question.steps) + 1;
  bool has_any = false;
  for (std::size_t p = 0; p < values_.size(); ++p) {
    if (question.means[p]) {
      values_[p].resize(positions);
      has_any = true;
    }
  }
  if (has_any) {
    of_lane_.resize(positions);
    lines_.resize(positions - 1);
    std::iota(of_lane_.begin(), of_lane_.end(), 0.0);
    integral_.place(of_lane_);
  }
}

void LaneMeans::find() {
  for (std::size_t p = 0; p < values_.size(); ++p) {
    for (std::size_t lane = 0; !values_[p].empty() && lane < kMotionLanes; ++lane) {
      for (std::size_t i = 0; i < of_lane_.size(); ++i) {
        of_lane_[i] = values_[p][i].numbers[lane];
      }
      for (std::size_t i = 0; i < lines_.size(); ++i) {
        lines_[i] = std::midpoint(of_lane_[i], of_lane_[i + 1]);
      }
      integral_.look(of_lane_);
      means_[p].numbers[lane] = integral_.of(of_lane_, lines_) / static_cast<double>(lines_.size());
    }
  }
}

}  // namespace kinestat
