// Where the power goes in one case, once velocities and actions are known.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// All in W. Lists are parallel to those of the Topology, that of loads to the case's.
struct PowerFlow {
  /// Of each coupling: its wrench on the motion of its head body (Cazangi 2008, 4.4.3, p. 86,
  /// virtual power); empty where the wrench is open, or a convention makes it (minimum norm).
  std::vector<std::optional<double>> into_head;

  /// Likewise on the motion of its tail body: what leaves the tail.
  std::vector<std::optional<double>> out_of_tail;
  std::vector<double> supplied;  ///< of each coupling: its wrench on its own motion; positive where
                                 ///< an actuator drives, negative where it brakes
  std::vector<double> actuators;  ///< of each actuator: its action times its rate
  std::vector<double> loads;      ///< of each load: its wrench on the motion of its body
  std::vector<double> friction;   ///< of each friction of the statics; never positive
  double input = 0.0;             ///< of the inputs named by the case, else the sum of all positive
                                  ///< powers of actuators and loads
  double largest = 0.0;           ///< size of the largest of all powers but those of friction
  /// Power of the outputs over that of the inputs, where the statics has friction and the case
  /// names both; empty where it has none: `no_efficiency` says why (see Efficiency).
  std::optional<double> efficiency;
  std::string no_efficiency;
  bool is_self_locking = false;   ///< friction takes more than the inputs give: outputs drive too
  double balance_residual = 0.0;  ///< |sum of supplied and loads| relative to the largest power
  bool is_balanced = true;        ///< the residual is at most kPowerBalance (Tellegen), or what
                                  ///< rounds where wrenches and motions far from the origin cancel
  /// How far the powers of actuators and the input may be off, relative to the largest of all
  /// powers; empty where rates or actions have no bounds.
  std::optional<double> error_bound;
};

/// Whether all friction and the actions of all actuators are known, not by convention. Passive
/// constraints may be open, as in a mechanism with redundant ones: they do no work.
bool determines_power(const Mechanism& mechanism, const StaticSolution& action);

/// The motion must be solved and the actions must determine the power, of the same mechanism and
/// case.
PowerFlow find_power(const Mechanism& mechanism,
                     const Case& which,
                     const KinematicSolution& motion,
                     const StaticSolution& action);

}  // namespace kinestat
