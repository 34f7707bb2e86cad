// A finite motion: what is asked, and the positions that were found.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "screw/pose.hpp"
#include "studies/motion/motion_network.hpp"

namespace kinestat {

/// The range of a driven freedom, measured from the drawn position [rad or m].
struct MotionDrive {
  int freedom = 0;  ///< index into Topology::freedoms
  double from = 0.0;
  double to = 0.0;
};

/// Where each drive is at a share of its motion [rad or m].
using DrivePath = std::function<double(std::size_t drive, double share)>;

/// All drives run from `from` to `to` together: steps + 1 positions.
struct MotionTask {
  std::vector<MotionDrive> drives;
  int steps = 360;
  std::vector<double> shares = {};  ///< of each position, of the ranges; empty: equal steps
  DrivePath path = {};              ///< instead of straight lines; then a share is of the path
  std::vector<double> turns = {};   ///< shares of the path, rising, without 0 and 1, between which
                                    ///< each drive runs one way or rests
  bool until_limit = false;  ///< the steps divide the way to where the drives turn back; `to` is
                             ///< how far that is looked for
};

enum class MotionStatus {
  completed,
  limit,          ///< a drive can go no further: MotionSolution::special ends with the limit
  lift_off,       ///< a cable leaves its pulley: MotionSolution::special ends with that position
  drives_locked,  ///< the drives cannot move at all: nothing is free that they could turn
  singular,       ///< the tangent of the motion is not unique, and nothing tells how to go on
  not_assembled,  ///< the drawn position does not close with the drives where they are drawn
  undetermined,   ///< the drives leave a freedom open that other bodies feel
  lost_branch,    ///< the path could not be followed within the tolerances
  not_movable     ///< a coupling has no finite law: MotionNetwork::obstacles
};

/// Where the network stands.
struct Configuration {
  std::vector<double> coordinates;  ///< of the joints of the network
  std::vector<double> angles;       ///< that are followed over full turns [rad]
};

enum class SpecialKind {
  limit,         ///< the drives turn back here
  change_point,  ///< another motion crosses: the rank of the closure drops
  lift_off,      ///< the arc of a cable on its pulley becomes zero
};

/// A position between two steps at which something happens.
struct SpecialPosition {
  SpecialKind kind = SpecialKind::limit;
  int step = 0;              ///< the last step before; -1: on the way from the drawn position to
                             ///< the first
  double share = 0.0;        ///< of the range of the drives
  double uncertainty = 0.0;  ///< of the share
  std::vector<double> drive_values;  ///< of each drive [rad or m], from the drawn position
  Configuration configuration;
  int contact = -1;  ///< of a cable that lifts off: index into Mechanism::contacts
};

/// The drawn position, closed with the drives held, or the nearest to that.
struct Assembly {
  bool closes = true;
  std::vector<CouplingMiss> drawn_misses;    ///< as drawn; those above rounding
  std::vector<BodyPose> corrections;         ///< of each body; empty where nothing was wrong
  std::vector<CouplingMiss> nearest_misses;  ///< where it does not close: at the nearest position
  Configuration nearest;                     ///< closed, or nearest to it
  bool closes_elsewhere = false;  ///< with the drives where they are drawn it does not close, but
                                  ///< with the drives as in `nearest` it does
};

/// Positions are kept as coordinates alone; everything else is worked out where it is asked
/// (`configuration_at`, then studies/motion/configuration.hpp, studies/motion/motion_state.hpp,
/// studies/motion/moved_mechanism.hpp).
struct MotionSolution {
  MotionStatus status = MotionStatus::completed;
  Assembly assembly;
  std::vector<MotionDrive> drives;  ///< `to` of a task until the limit is where that was found
  DrivePath path;                   ///< as in the task
  std::vector<double> turns;        ///< likewise
  std::vector<double> shares;       ///< of each position found, rising from 0; the last is a limit
                                    ///< or lift-off where the status says so
  std::vector<double> closure_errors;  ///< of each: largest, as share of the mechanism's size
  std::vector<double> coordinates;     ///< those of all positions, one after the other
  std::vector<double> angles;          ///< likewise
  int coordinate_count = 0;
  int angle_count = 0;
  bool closes_by_least_squares = false;  ///< some position misses by more than rounding
  std::vector<double> lost_at;           ///< each drive where a lost branch ends [rad or m]
  std::vector<SpecialPosition> special;  ///< in the order of the motion
  std::vector<int> open_freedoms;        ///< that the drives leave open and other bodies feel
  std::vector<int> passive_freedoms;     ///< that they leave open and no other body feels

  int position_count() const { return static_cast<int>(shares.size()); }

  /// The position of a drive at a share of the motion [rad or m].
  double drive_at(std::size_t drive, double share) const {
    const MotionDrive& one = drives[drive];
    return path ? path(drive, share) : one.from + share * (one.to - one.from);
  }

  /// The position of a drive at one of the positions [rad or m].
  double drive_value(std::size_t drive, int position) const {
    return drive_at(drive, shares[static_cast<std::size_t>(position)]);
  }

  Configuration configuration_at(int position) const;
};

}  // namespace kinestat
