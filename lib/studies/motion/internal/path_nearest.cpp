#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/index.hpp"
#include "studies/motion/internal/largest.hpp"
#include "studies/motion/internal/motion_limits.hpp"
#include "studies/motion/internal/path_tracker.hpp"

namespace kinestat {

// Levenberg and Marquardt: the step is held back while it does not bring the ends together.
template <class Frames>
void PathTracker<Frames>::find_nearest(PathPoint& point,
                                       bool moves_drives,
                                       std::span<const double> along) {
  std::vector<int> columns = unknown_;
  if (moves_drives) {
    columns.insert(columns.end(), driven_.begin(), driven_.end());
  }
  const int rows = system_.row_count();
  const int count = static_cast<int>(columns.size());
  const int held = along.empty() ? 0 : 1;
  const int height = rows + held + count;
  const auto missed = [&](const std::vector<double>& residuals) {
    return std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
  };
  double damping = kFirstDamping;
  system_.evaluate(point.coordinates, point.angles);
  double now = missed(system_.residuals());
  std::vector<double> matrix;
  for (int round = 0; round < kMostNearestRounds && damping < kMostDamping; ++round) {
    gather(columns, matrix);
    std::vector<double> damped(at(height * count), 0.0);
    std::vector<double> right(at(height), 0.0);
    for (int c = 0; c < count; ++c) {
      double* column = damped.data() + c * height;
      std::copy_n(matrix.data() + c * rows, rows, column);
      if (held > 0) {
        column[rows] = along[at(columns[at(c)])];
      }
      column[rows + held + c] = std::sqrt(damping);
    }
    std::ranges::transform(
        system_.residuals(), right.begin(), [](double residual) { return -residual; });
    qr_.factor(damped, height, count);
    std::vector<double> by(at(count));
    qr_.solve(right, by);
    std::ranges::fill(correction_, 0.0);
    for (int c = 0; c < count; ++c) {
      correction_[at(columns[at(c)])] = by[at(c)];
    }
    std::vector<double> next = point.coordinates;
    system_.move(correction_, next);
    system_.evaluate(next, point.angles);
    const double then = missed(system_.residuals());
    if (then <= now) {
      point.coordinates = std::move(next);
      system_.follow_angles(point.angles);
      for (std::size_t i = 0; i < point.arrival.size(); ++i) {
        point.arrival[i] += correction_[i];
      }
      damping *= 0.1;
      now = then;
      if (largest(by) <= kLeastCorrection || system_.largest_residual() <= kEpsilon) {
        break;
      }
    } else {
      damping *= 10.0;
      system_.evaluate(point.coordinates, point.angles);
    }
  }
  point.closure_error = system_.largest_residual();
}

template void PathTracker<PlanarFrames>::find_nearest(PathPoint&, bool, std::span<const double>);
template void PathTracker<SpatialFrames>::find_nearest(PathPoint&, bool, std::span<const double>);

}  // namespace kinestat
