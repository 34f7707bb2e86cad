// What torque converters do in a case.
#pragma once

#include <optional>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// The state of one torque converter. Torques act about the axis of the coupling, in the sense in
/// which speeds count [N·m]. The turbine torque is the sum of the pump and stator torques.
struct ConverterState {
  CouplingId coupling = {};                ///< of pump and turbine
  double pump_speed = 0.0;                 ///< seen from the stator [rad/s]
  double turbine_speed = 0.0;              ///< likewise
  std::optional<double> speed_ratio = {};  ///< empty where the pump rests
  double torque_ratio = 1.0;
  double pump_torque = 0.0;
  double turbine_torque = 0.0;
  double stator_torque = 0.0;  ///< of the stator on the turbine
  double lost = 0.0;           ///< power that heats the fluid [W]

  /// The power it gives over the power it takes: speed ratio times torque ratio while the pump
  /// drives. Zero at stall and where both shafts drive it; empty if the pump takes no power.
  std::optional<double> efficiency() const;
};

/// Finds the state of each converter, in the order of mechanism.frictions. A converter is left out
/// if its characteristic has no value at its speeds. `motion` must be solved.
std::vector<ConverterState> find_converter_states(const Mechanism& mechanism,
                                                  const KinematicSolution& motion);

}  // namespace kinestat
