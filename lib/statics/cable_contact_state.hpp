// Whether cables stick to their pulleys or slip.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

enum class BeltState {
  unknown,       ///< without friction, or without both tensions
  sticking,      ///< the ratio of the tensions is within the limit
  slipping,      ///< the case moves the cable over the pulley
  beyond_limit,  ///< the ratio is beyond the limit, and the case does not let the cable slip
};

/// The word in reports.
constexpr std::string_view word_of(BeltState belt_state) {
  switch (belt_state) {
    case BeltState::unknown:
      return "unknown";
    case BeltState::sticking:
      return "sticking";
    case BeltState::slipping:
      return "slipping";
    case BeltState::beyond_limit:
      return "beyond the limit";
  }
  return "";
}

/// One contact of a cable with a pulley in one case, SI units.
struct CableContactState {
  std::optional<double> before;      ///< tension T_1 of the segment that arrives [N]
  std::optional<double> after;       ///< tension T_2 of the segment that leaves [N]
  std::optional<double> ratio;       ///< of the larger tension to the smaller, if both pull
  std::optional<double> limit;       ///< exp(μ θ), the largest ratio that friction holds
  std::optional<double> slip_speed;  ///< of the cable over the pulley, in the cable's order [m/s]
  std::optional<double> slip_power;  ///< (T_1 - T_2) times the slip speed [W]
  BeltState belt_state = BeltState::unknown;
};

/// Finds the state of each contact, in the order of mechanism.contacts; none if the case has no
/// actions. `motion` may be null: then it is not known whether cables slip.
std::vector<CableContactState> find_cable_contact_states(const Mechanism& mechanism,
                                                         const StaticSolution& solution,
                                                         const KinematicSolution* motion);

}  // namespace kinestat
