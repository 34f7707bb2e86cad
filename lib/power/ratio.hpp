// Transmission ratios of a case with one output.
#pragma once

#include <optional>
#include <string>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Empty with a reason where the output rests or carries nothing.
struct Ratios {
  std::optional<double> ratio;         ///< i = rate of the input / rate of the output (eq. 5.1)
  std::optional<double> torque_ratio;  ///< Γ = action of the input / of the output (eq. 5.2)
  std::optional<double> advantage;     ///< |action of the output / of the input|
  std::string reason;                  ///< why `ratio` is empty
  std::string fraction;                ///< the ratio without rounding, "52/17", where numbers of
                                       ///< teeth make it one and were asked for (tooth_ratio)

  /// Relative errors that they may have at most, 1 where not one digit is sure; empty where rates
  /// or actions have no bounds, or the ratio has no value.
  std::optional<double> ratio_bound;
  std::optional<double> torque_ratio_bound;
};

/// Whether the case names what ratios are of: inputs and one output that are actuators.
bool has_ratio_ends(const Case& which);

/// Why a case has no ratio, "has the load 'rope' for its output, which has no speed", and what to
/// type.
struct MissingEnds {
  std::string what;
  std::string hint;
};

/// Of a case without `has_ratio_ends`.
MissingEnds missing_ratio_ends(const Mechanism& mechanism, const Case& which);

/// Ratios of the case (Cazangi 2008, eqs. 5.1 and 5.2). `action` may be null: no torque ratio then.
/// Several inputs count as one if they have the same rate; their actions add up (both clutches of
/// a direct gear). `has_ratio_ends` must hold, and `motion` must be solved.
Ratios find_ratios(const Mechanism& mechanism,
                   const Case& which,
                   const KinematicSolution& motion,
                   const StaticSolution* action);

/// Adds Γ and the mechanical advantage of such a case; nothing where an action is open or rests on
/// a convention.
void add_torque_ratio(const Mechanism& mechanism,
                      const Case& which,
                      const StaticSolution& action,
                      Ratios& ratios);

}  // namespace kinestat
