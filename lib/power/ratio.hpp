// Transmission ratios of a case with one output.
#pragma once

#include <optional>
#include <string>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// The ratios of a case. A ratio is empty if the output is at rest or has no action: see `reason`.
struct Ratios {
  std::optional<double> ratio;         ///< i = rate of the input / rate of the output (eq. 5.1)
  std::optional<double> torque_ratio;  ///< Γ = action of the input / of the output (eq. 5.2)
  std::optional<double> advantage;     ///< |action of the output / of the input|
  std::string reason;                  ///< why `ratio` is empty
  std::string fraction;                ///< the ratio without rounding, "52/17", if numbers of teeth
                                       ///< determine it and it was asked for (tooth_ratio)

  /// Bounds of the relative errors of both ratios; 1 if not one digit is certain. Empty if rates or
  /// actions have no bounds, or if the ratio has no value.
  std::optional<double> ratio_bound;
  std::optional<double> torque_ratio_bound;
};

/// Whether the case names what a ratio needs: inputs and one output, all of them actuators.
bool has_ratio_ends(const Case& which);

/// Why a case has no ratio, such as "has the load 'rope' for its output, which has no speed", and a
/// hint what to type.
struct MissingEnds {
  std::string what;
  std::string hint;
};

/// For a case for which has_ratio_ends is false.
MissingEnds missing_ratio_ends(const Mechanism& mechanism, const Case& which);

/// The ratios of a case (Cazangi 2008, eqs. 5.1 and 5.2). Without `action`, which may be null,
/// there is no torque ratio. Several inputs with the same rate count as one, with the sum of their
/// actions (both clutches of a direct gear). has_ratio_ends must hold, and `motion` must be solved.
Ratios find_ratios(const Mechanism& mechanism,
                   const Case& which,
                   const KinematicSolution& motion,
                   const StaticSolution* action);

/// Adds the torque ratio Γ and the mechanical advantage of such a case. Adds nothing if an action
/// is open or known only by convention.
void add_torque_ratio(const Mechanism& mechanism,
                      const Case& which,
                      const StaticSolution& action,
                      Ratios& ratios);

}  // namespace kinestat
