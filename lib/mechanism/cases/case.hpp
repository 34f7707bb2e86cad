// A case bound to numbers: what is known of the motions and actions, and what acts from outside.
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
  std::string given;  ///< how the file names it: an actuator, or coupling.freedom
  SourceRange where;
  bool is_assumed = false;  ///< not of the file: the rate of a freedom that no other body feels
  std::shared_ptr<const NumberLaw<double>> law =
      nullptr;  ///< of an action that follows curves: its value is known once the case is solved
  double relative_bound = 0.0;  ///< by what share of itself the value may be off: one searched for

  bool moves() const { return law != nullptr; }
};

/// Inputs and outputs are actuators and loads, by their indices; empty where the file does not say.
struct Case {
  std::string label;
  bool asks_motions = false;  ///< velocities are to be solved, even if none is known
  bool asks_actions = false;  ///< actions are to be solved: the key is there, or loads act
  std::vector<Primary> motions;
  std::vector<Primary> actions;
  std::optional<std::vector<Primary>> accelerations =
      {};  ///< [rad/s² or m/s²] of some of `motions`, the others being steady: the forces of
           ///< inertia act; empty: they do not
  std::vector<Load> loads;   ///< on moving bodies: those of the file, then the weights, and once it
                             ///< is solved those that follow curves, springs and inertia
  std::vector<int> inputs;   ///< actuators
  std::vector<int> outputs;  ///< likewise
  std::vector<std::size_t> input_loads = {};  ///< of `loads`, `moving_loads` behind them: what
                                              ///< drives as a weight that sinks
  std::vector<std::size_t> output_loads = {};
  std::vector<MovingLoad> moving_loads = {};  ///< of the file, on moving bodies
  SourceRange where;
  bool is_gear = false;  ///< of `shift`: it may leave open what neither inputs nor outputs feel

  bool has_inertia() const { return accelerations.has_value(); }

  bool follows_curves() const {
    return !moving_loads.empty() || std::ranges::any_of(actions, &Primary::moves);
  }

  /// Whether the file says where power goes in and where it comes out.
  bool names_both_ends() const {
    return !(inputs.empty() && input_loads.empty()) && !(outputs.empty() && output_loads.empty());
  }
};

/// How fast a known motion of the case speeds up [rad/s² or m/s²]: steady where nothing says so.
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
