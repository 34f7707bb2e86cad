// What torque converters do in a case.
#pragma once

#include <optional>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// SI units; couples about the axis of the coupling, in the sense in which speeds count. What the
/// pump takes and the stator gives, the turbine gives.
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

  /// What it gives by what it takes, by speed and torque ratio while the pump drives; zero at
  /// stall and where both shafts drive it, empty where nothing flows.
  std::optional<double> efficiency() const;
};

/// In the order of mechanism.frictions; without those whose characteristic has no value there.
/// `motion` must be solved.
std::vector<ConverterState> find_converter_states(const Mechanism& mechanism,
                                                  const KinematicSolution& motion);

}  // namespace kinestat
