// Friction of a coupling, bound to numbers.
#pragma once

#include <optional>

#include "core/source.hpp"
#include "core/types.hpp"

namespace kinestat {

/// SI units. What each type uses:
/// - revolute: couple μ r R, R the force across the axis; and tau + c |ω|;
/// - helical: couple |Ra| (r tan(λ ± φ) ∓ h) with tan λ = h / r, tan φ = μ; and tau + c |ω|;
/// - prismatic: force μ R, R the force across the axis, or the two edge forces of a guide of that
///   length; and c |v|;
/// - contacts of surfaces or teeth: force μ N against the sliding.
struct CouplingFriction {
  CouplingId coupling;
  double mu = 0.0;
  double radius = 0.0;           ///< of the journal, or mean radius of the thread [m]
  std::optional<double> length;  ///< of the guide [m]
  double tau = 0.0;              ///< [N·m]
  double viscous = 0.0;          ///< c [N·m·s/rad or N·s/m]
  SourceRange where;
};

}  // namespace kinestat
