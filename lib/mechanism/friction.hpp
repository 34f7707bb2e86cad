// Friction of a coupling, bound to numbers.
#pragma once

#include <optional>

#include "core/source.hpp"
#include "core/types.hpp"

namespace kinestat {

/// SI units. What each type uses:
/// - revolute: couple μ r R, R the force across the axis, or μ r times the forces at the two ends
///   of a journal of that length, which bear a couple across the axis too; μ r_t times the axial
///   force; and tau + c |ω|;
/// - helical: couple |Ra| (r tan(λ ± φ) ∓ h) with tan λ = h / r, tan φ = μ; and tau + c |ω|;
/// - prismatic: force μ R, R the force across the axis, or the two edge forces of a guide of that
///   length; μ / r times the couple about the axis; and c |v|;
/// - contacts of surfaces or teeth: force μ N against the sliding.
/// `Scalar` is double or Dual.
template <class Scalar>
struct CouplingFrictionOf {
  CouplingId coupling;
  Scalar mu = 0.0;
  Scalar radius = 0.0;           ///< of the journal, mean one of the thread, or at which the guide
                                 ///< is kept from turning; 0: its couple does not rub [m]
  Scalar thrust_radius = 0.0;    ///< mean one of the collar; 0: the axial force does not rub [m]
  std::optional<Scalar> length;  ///< of the guide or journal [m]
  Scalar tau = 0.0;              ///< [N·m]
  Scalar viscous = 0.0;          ///< c [N·m·s/rad or N·s/m]
  SourceRange where;
};

using CouplingFriction = CouplingFrictionOf<double>;

}  // namespace kinestat
