// The equations of closure with lengths in sizes of the part of the mechanism that they close, so
// that how near it is to a singular position does not depend on how far away others are.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/index.hpp"
#include "studies/motion/internal/closure_rows.hpp"
#include "studies/motion/motion_network.hpp"

namespace kinestat {

class ClosureParts {
 public:
  /// Of each row, as the ClosureSystem has them.
  ClosureParts(const MotionNetwork& network,
               const std::vector<bool>& is_length,
               std::span<const RatesOfRow> rates_of_rows);

  /// There is one, or all are as large as the mechanism: nothing to measure.
  bool are_whole() const { return are_whole_; }

  /// The columns of these rates, one after the other.
  void measure(std::span<double> matrix, std::span<const int> rates) const;

  /// What a row misses most.
  double largest(std::span<const double> residuals) const;

 private:
  bool are_whole_ = true;
  std::vector<double> of_rows_;   // sizes of the mechanism by that of the part; 1: of angles
  std::vector<double> of_rates_;  // likewise; 1: of a turn
};

inline ClosureParts::ClosureParts(const MotionNetwork& network,
                                  const std::vector<bool>& is_length,
                                  std::span<const RatesOfRow> rates_of_rows)
    : are_whole_(std::ranges::all_of(network.part_lengths,
                                     [&](double one) { return one == network.length; })),
      of_rows_(rates_of_rows.size(), 1.0),
      of_rates_(at(network.rate_count), 1.0) {
  if (are_whole_) {
    return;
  }
  std::vector<double> part_of_rate(at(network.rate_count), 0.0);
  std::vector<bool> is_slide(at(network.rate_count), false);
  for (const MotionJoint& joint : network.joints) {
    if (joint.rate >= 0 && joint.freedom >= 0) {
      part_of_rate[at(joint.rate)] = network.length / network.part_lengths[at(joint.freedom)];
      is_slide[at(joint.rate)] = joint.motion.kind == ElementaryKind::slide;
    }
  }
  // The rates of teeth are of several parts; those of a rack are as long as it slides.
  const std::size_t first_of_teeth = of_rows_.size() - network.rollings.size();
  // Free bodies and the turns of balls have the part of the others in their row.
  for (std::size_t r = 0; r < of_rows_.size(); ++r) {
    double part = 1.0;
    for (const int rate : rates_of_rows[r].all) {
      const bool counts = r < first_of_teeth || is_slide[at(rate)];
      part = std::max(part, counts ? part_of_rate[at(rate)] : 1.0);
    }
    of_rows_[r] = is_length[r] || r >= first_of_teeth ? part : 1.0;
    for (const int rate : rates_of_rows[r].all) {
      of_rates_[at(rate)] = part_of_rate[at(rate)] > 0.0 ? part_of_rate[at(rate)] : part;
    }
  }
  for (const MotionJoint& joint : network.joints) {
    const bool is_ball = joint.motion.kind == ElementaryKind::ball;
    const bool slides = joint.motion.kind == ElementaryKind::slide;
    for (int i = 0; joint.rate >= 0 && !slides && i < (is_ball ? 3 : 1); ++i) {
      of_rates_[at(joint.rate + i)] = 1.0;
    }
  }
}

inline void ClosureParts::measure(std::span<double> matrix, std::span<const int> rates) const {
  auto entry = matrix.begin();
  for (const int rate : rates) {
    for (const double of_row : of_rows_) {
      *entry++ *= of_row / of_rates_[at(rate)];
    }
  }
}

inline double ClosureParts::largest(std::span<const double> residuals) const {
  double most = 0.0;
  for (std::size_t r = 0; r < residuals.size(); ++r) {
    const double one = of_rows_[r] * std::abs(residuals[r]);
    most = std::isnan(one) || one > most ? one : most;
  }
  return most;
}

}  // namespace kinestat
