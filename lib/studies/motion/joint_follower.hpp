// Configurations near others on the same branch, and which joints tell them apart.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "studies/motion/motion_solution.hpp"

namespace kinestat {

/// Moves configurations along the drives of a network, each of which is a joint of its tree. One a
/// thread; the network must outlive it.
class JointFollower {
 public:
  explicit JointFollower(const MotionNetwork& network);
  ~JointFollower();
  JointFollower(const JointFollower&) = delete;
  JointFollower& operator=(const JointFollower&) = delete;

  /// Where the drives are [rad or m].
  void read_drives(const Configuration& configuration, std::span<double> drives) const;

  /// Moves a closed configuration to where the drives are there, by Newton from the tangent, in
  /// parts where that is far. False where its branch cannot be followed so far.
  [[nodiscard]] bool follow(Configuration& configuration, std::span<const double> drives);

  /// The rates of all joints for a unit rate of each drive, a column each [rad, or sizes of the
  /// mechanism]; empty where the drives do not determine them.
  [[nodiscard]] std::optional<MatX> unit_rates(const Configuration& configuration);

  /// Motions that the closure leaves to all joints, without those that no other body feels, in
  /// orthonormal columns: as many as a set of independent drives has.
  [[nodiscard]] MatX free_motions(const Configuration& configuration);

 private:
  struct Solver;

  std::unique_ptr<Solver> solver_;
};

/// The rate of the joint that a freedom of a tree has; -1 where it has none with a coordinate.
int rate_of_freedom(const MotionNetwork& network, int freedom);

/// The same network with other drives, by the rates of their joints.
MotionNetwork with_drives(MotionNetwork network, std::span<const int> rates);

/// Rows of the matrix, whose columns are motions, that tell these apart best, the largest pivot
/// first; of joints with a coordinate alone. `first` are taken before, and stay out where they
/// depend on each other; fewer than the columns where no more are independent.
std::vector<int> independent_rates(const MotionNetwork& network,
                                   MatX motions,
                                   std::span<const int> first);

}  // namespace kinestat
