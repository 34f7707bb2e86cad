// The friction of a coupling, bound to numbers.
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

/// A coupling whose wrench counts with that sign in a sum.
struct CountedCoupling {
  CouplingId coupling;
  double sign = 1.0;
};

/// The friction of a cable on a pulley, on which no other couple acts: the tension of the segment
/// towards which the cable runs is `ratio` times that of the other. On a drum there is only one
/// segment.
struct CableFriction {
  std::optional<CouplingId> arrives;  ///< the segment before the pulley in the order of the cable
  std::optional<CouplingId> leaves;   ///< the segment after it
  double radius = 0.0;  ///< [m] signed: speed of the cable onwards over the rate of the coupling
  double ratio = 1.0;   ///< exp(μ θ) of a cable that slips, divided by the efficiency η
  bool slips = false;   ///< whether the coupling is the slip, and not that on which a pulley turns
  std::optional<CouplingId> unless_slip = {};  ///< of a cable that may slip, on the coupling on
                                               ///< which its pulley turns: not while that one slips
};

/// The name, in an expression for `tau`, of the absolute value of the relative angular velocity.
inline constexpr std::string_view kSpeedOfFriction = "speed";

/// The friction of a coupling in SI units. The friction of each type is
/// - revolute: couple μ r R, R being the force across the axis; with a length, μ r
///   times the forces at the two ends of the journal, which also bear a couple across the axis; μ
///   r_t times the axial force; and tau + c |ω|;
/// - helical: couple |Ra| (r tan(λ ± φ) ∓ h) with tan λ = h / r, tan φ = μ; and tau + c |ω|;
/// - prismatic: force μ R, R being the force across the axis or, with a length, the two forces at
///   the ends of the guide; μ / r times the couple about the axis; and c |v|;
/// - a revolute under a pulley: the larger of the couples |r| (1 - 1/k) T, T being the tension
///   ahead and k the ratio of the cable, and |r| (k - 1) T', T' being that behind. They are equal
///   where nothing else turns the pulley; one that drives its cable loses the second, one that it
///   drives the first, a drum that of its only strand. Of a cable that slips it is the first
///   (Eytelwein);
/// - contacts of surfaces or teeth: force μ N against the sliding;
/// - open clutches and brakes: couple tau + c |ω|;
/// - torque converters: the couple by `converter`, which need not oppose the motion.
/// `Scalar` is double or Dual.
template <class Scalar>
struct CouplingFrictionOf {
  CouplingId coupling;
  Scalar mu = 0.0;
  std::optional<Scalar> mu_static = {};  ///< at rest, not below mu; used by simulations only
  Scalar radius = 0.0;           ///< of the journal, the mean thread, or the surface that keeps the
                                 ///< guide from turning [m]; 0: that couple causes no friction
  Scalar thrust_radius = 0.0;    ///< of the mean collar [m]; 0: the axial force causes no friction
  std::optional<Scalar> length;  ///< of the guide or journal [m]
  Scalar tau = 0.0;              ///< [N·m]; value at rest if it depends on the speed
  std::optional<NumberLaw<Scalar>> tau_of_speed;  ///< [N·m], if `tau` depends on kSpeedOfFriction
  Scalar viscous = 0.0;                           ///< c [N·m·s/rad or N·s/m]
  std::shared_ptr<const ConverterLawOf<Scalar>> converter;  ///< of a torque converter; may be null
  std::vector<CableFriction> cables;  ///< over the pulley that turns on the coupling
  int planets = 1;  ///< number of equal planets that are drawn as one; tau and c are of one bearing
  bool is_balanced = false;  ///< only equal planets press across the axis; their forces cancel
  std::vector<CountedCoupling> beside;  ///< their wrenches, added to its own, leave what it bears
                                        ///< across the axis without what of equal planets cancels
  SourceRange where;
};

using CouplingFriction = CouplingFrictionOf<double>;

/// Whether it is zero at rest, so that nothing jumps where the motion reverses.
inline bool vanishes_at_rest(const CouplingFriction& friction) {
  return friction.mu == 0.0 && friction.tau == 0.0 && friction.cables.empty();
}

/// The couple tau [N·m], which does not depend on the load, at `speed`, the absolute value of the
/// relative angular velocity [rad/s]. Empty if the expression of the file has no value there, or a
/// negative one.
template <class Scalar>
std::optional<Scalar> tau_at(const CouplingFrictionOf<Scalar>& friction, const Scalar& speed);

}  // namespace kinestat
