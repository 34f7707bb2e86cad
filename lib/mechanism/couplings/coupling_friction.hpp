// Friction of a coupling, bound to numbers.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/source.hpp"
#include "core/types.hpp"
#include "expression/number_law.hpp"
#include "mechanism/couplings/torque_converter.hpp"

namespace kinestat {

/// A cable that runs over a pulley: the tension ahead, where it runs to, is `ratio` times that
/// behind. A drum has the cable on one side alone.
struct CableFriction {
  std::optional<CouplingId> arrives;  ///< the segment before the pulley in the order of the cable
  std::optional<CouplingId> leaves;   ///< the segment after it
  double radius = 0.0;  ///< [m] signed: the cable runs onwards at the rate of the coupling times it
  double ratio = 1.0;   ///< exp(μ θ) of a cable that slips, divided by the efficiency η
};

/// What `tau` of a friction calls the size of its relative angular velocity.
inline constexpr std::string_view kSpeedOfFriction = "speed";

/// SI units. What each type uses:
/// - revolute: couple μ r R, R the force across the axis, or μ r times the forces at the two ends
///   of a journal of that length, which bear a couple across the axis too; μ r_t times the axial
///   force; and tau + c |ω|;
/// - helical: couple |Ra| (r tan(λ ± φ) ∓ h) with tan λ = h / r, tan φ = μ; and tau + c |ω|;
/// - prismatic: force μ R, R the force across the axis, or the two edge forces of a guide of that
///   length; μ / r times the couple about the axis; and c |v|;
/// - a revolute under a pulley: couple |r| (1 - 1/k) T, T being the tension ahead and k the ratio
/// of
///   the cable (Eytelwein); of a drum that winds up, |r| (k - 1) T;
/// - contacts of surfaces or teeth: force μ N against the sliding;
/// - clutches and brakes that are open: couple tau + c |ω|;
/// - torque converters: what `converter` says, against nobody's motion.
/// `Scalar` is double or Dual.
template <class Scalar>
struct CouplingFrictionOf {
  CouplingId coupling;
  Scalar mu = 0.0;
  std::optional<Scalar> mu_static = {};  ///< in its place at rest, no less; of simulations alone
  Scalar radius = 0.0;         ///< of the journal, mean one of the thread, or at which the guide
                               ///< is kept from turning; 0: no friction from its couple [m]
  Scalar thrust_radius = 0.0;  ///< mean one of the collar; 0: no friction from the axial force [m]
  std::optional<Scalar> length;                   ///< of the guide or journal [m]
  Scalar tau = 0.0;                               ///< [N·m] at rest, where it depends on the speed
  std::optional<NumberLaw<Scalar>> tau_of_speed;  ///< [N·m], where the file names kSpeedOfFriction
  Scalar viscous = 0.0;                           ///< c [N·m·s/rad or N·s/m]
  std::shared_ptr<const ConverterLawOf<Scalar>> converter;  ///< of a torque converter; may be null
  std::vector<CableFriction> cables;  ///< over the pulley that turns on the coupling
  int planets = 1;  ///< equal ones that stand for each other, tau and c being of one bearing
  bool is_balanced = false;  ///< nothing but equal planets presses it across its axis, and these
                             ///< from all sides
  SourceRange where;
};

using CouplingFriction = CouplingFrictionOf<double>;

/// The couple that does not depend on the load, at a size of the relative angular velocity [rad/s].
/// Empty where the file's expression has no value there, or a negative one.
template <class Scalar>
std::optional<Scalar> tau_at(const CouplingFrictionOf<Scalar>& friction, const Scalar& speed);

}  // namespace kinestat
