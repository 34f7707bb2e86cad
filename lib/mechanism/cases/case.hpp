// A case bound to numbers: known motions and actions, loads, inputs and outputs.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/source.hpp"
#include "mechanism/cases/load.hpp"
#include "mechanism/cases/moving_load.hpp"

namespace kinestat {

/// A known magnitude: of a freedom [rad/s or m/s] or of an action [N·m or N].
struct Primary {
  int index = 0;  ///< into Topology::freedoms or Topology::actions
  double value = 0.0;
  std::string given;  ///< its name in the file: an actuator, or coupling.freedom
  SourceRange where;
  bool is_assumed = false;  ///< a rate of an idle freedom that is assumed to be zero
  std::shared_ptr<const NumberLaw<double>> law =
      nullptr;  ///< of an action that follows curves: its value is known once the motion is solved
  double relative_bound = 0.0;  ///< bound of the relative error, of a value that was searched for

  bool moves() const { return law != nullptr; }
};

/// A case. Inputs and outputs are indices of actuators and loads; empty if the file names none.
struct Case {
  std::string label;
  bool asks_motions = false;  ///< whether to solve for velocities, even if none is known
  bool asks_actions = false;  ///< whether to solve for actions: the file has the key, or loads act
  std::vector<Primary> motions;
  std::vector<Primary> actions;
  std::optional<std::vector<Primary>> accelerations =
      {};  ///< of some of `motions` [rad/s² or m/s²], those of the others being zero; empty if
           ///< no inertia forces act
  std::vector<Load> loads;  ///< on moving bodies: those of the file, then weights; once the case is
                            ///< solved also those of curves, springs and inertia
  std::vector<int> inputs;  ///< indices of actuators
  std::vector<int> outputs;                   ///< indices of actuators
  std::vector<std::size_t> input_loads = {};  ///< loads that drive, such as a sinking weight:
                                              ///< indices into `loads` followed by `moving_loads`
  std::vector<std::size_t> output_loads = {};
  std::vector<MovingLoad> moving_loads = {};  ///< of the file, on moving bodies
  SourceRange where;
  bool is_gear = false;  ///< of `shift`; it may leave open what moves beside the power path

  bool has_inertia() const { return accelerations.has_value(); }

  bool follows_curves() const {
    return !moving_loads.empty() || std::ranges::any_of(actions, &Primary::moves);
  }

  /// Whether the file names both inputs and outputs.
  bool names_both_ends() const {
    return !(inputs.empty() && input_loads.empty()) && !(outputs.empty() && output_loads.empty());
  }
};

/// The acceleration of a known motion of the case [rad/s² or m/s²]; zero if none is given.
inline double acceleration_of(const Case& which, int freedom) {
  if (which.accelerations) {
    for (const Primary& one : *which.accelerations) {
      if (one.index == freedom) {
        return one.value;
      }
    }
  }
  return 0.0;
}

}  // namespace kinestat
