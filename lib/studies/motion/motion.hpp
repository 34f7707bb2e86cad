// Finite motion: the closure of a network followed along its drives.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "studies/motion/motion_solution.hpp"

namespace kinestat {

/// Closes the drawn position, goes to where the drives begin, and follows them to their end on the
/// branch that was drawn: predictor and corrector by Newton on screws, with steps as small as the
/// branch asks for. Every position is closed to kMotionClosure of the size, or to the least squares
/// of an overconstrained mechanism that is not drawn exactly. The drives of the task must be those
/// of the network, in that order.
[[nodiscard]] MotionSolution solve_motion(const MotionNetwork& network, const MotionTask& task);

/// Follows the drives of a motion between its positions, again and again. One a thread.
class WayBetween {
 public:
  /// By the drives of the motion; the network must outlive it.
  WayBetween(const MotionNetwork& network, const MotionSolution& motion);
  ~WayBetween();
  WayBetween(const WayBetween&) = delete;
  WayBetween& operator=(const WayBetween&) = delete;

  /// On from a position at one share of the ranges to a later one, on its branch; empty where it
  /// cannot be followed.
  [[nodiscard]] std::optional<Configuration> follow(const Configuration& start,
                                                    double start_share,
                                                    double share);

 private:
  struct Solver;

  std::unique_ptr<Solver> solver_;
};

}  // namespace kinestat
