// The powers in one case, once velocities and actions are known.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// The powers of one case [W]. Lists are parallel to those of the Topology, the list of loads to
/// that of the case.
struct PowerFlow {
  /// Of each coupling: the power of its wrench on the motion of its head (Cazangi 2008, 4.4.3,
  /// p. 86, virtual power). Empty if the wrench is open, or a convention (minimum norm).
  std::vector<std::optional<double>> into_head;

  /// Of each coupling: the power of its wrench on the motion of its tail, which leaves the tail.
  std::vector<std::optional<double>> out_of_tail;
  std::vector<double> supplied;  ///< of each coupling: its wrench on the motion of head relative to
                                 ///< tail; positive if an actuator drives, negative if it brakes
  std::vector<double> actuators;  ///< of each actuator: its action times its rate
  std::vector<double> loads;      ///< of each load: its wrench on the motion of its body
  std::vector<double> friction;   ///< of each friction in the statics; never positive
  double input = 0.0;             ///< of the inputs that the case names; without these the sum of
                                  ///< all positive powers of actuators and loads
  double largest = 0.0;           ///< absolute value of the largest power, friction excepted
  /// Power of the outputs over power of the inputs, if the statics has friction and the case names
  /// both. If it is empty, `no_efficiency` says why (see Efficiency).
  std::optional<double> efficiency;
  std::string no_efficiency;
  bool is_self_locking = false;   ///< friction exceeds the power of the inputs: outputs drive too
  double balance_residual = 0.0;  ///< |sum of supplied and loads| relative to the largest power
  bool is_balanced = true;        ///< the residual is at most kPowerBalance (Tellegen), or is due
                                  ///< to rounding of large wrenches and motions that cancel
  /// Error bound of the powers of actuators and of the input, relative to the largest of all
  /// powers. Empty if rates or actions have no bounds.
  std::optional<double> error_bound;
};

/// Whether all friction and the actions of all actuators are known, and not by convention. Passive
/// constraints may be open, as in a mechanism with redundant constraints: they do no work.
bool determines_power(const Mechanism& mechanism, const StaticSolution& action);

/// Computes the powers. The motion must be solved and the actions must determine the power
/// (determines_power), both of the same mechanism and case.
PowerFlow find_power(const Mechanism& mechanism,
                     const Case& which,
                     const KinematicSolution& motion,
                     const StaticSolution& action);

}  // namespace kinestat
