// Means of positions of many linkages over the way of their drive.
#pragma once

#include <cstddef>
#include <vector>

#include "math/dense/smooth_integral.hpp"
#include "studies/motion/lanes/lane_group.hpp"
#include "studies/motion/lanes/lane_question.hpp"

namespace kinestat {

/// Of the places of a question of which the mean is asked, by the integral that motions take.
class LaneMeans {
 public:
  explicit LaneMeans(const LaneQuestion& question);

  void keep(std::size_t place, std::size_t step, const LaneGroup& value) {
    if (!values_[place].empty()) {
      values_[place][step] = value;
    }
  }

  /// Once all steps are kept.
  void find();

  /// Zero where none is asked.
  double of(std::size_t place, std::size_t lane) const { return means_[place].numbers[lane]; }

 private:
  std::vector<LaneGroups> values_;  // of each place, at the steps; empty where no mean is asked
  LaneGroups means_;
  SmoothIntegral integral_;
  std::vector<double> of_lane_;  // the values of one
  std::vector<double> lines_;
};

}  // namespace kinestat
