// What friction a coupling has, as a function of the actions that it bears.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// A part of the reaction that presses: |part · wrench| times a weight. A scalar part may have
/// another weight where it is negative. `Scalar` is double or Dual.
template <class Scalar>
struct PressingPartOf {
  std::optional<CouplingId> of;  ///< whose wrench presses; empty: that of the law's own coupling
  Eigen::Matrix<Scalar, 3, 6> part = Eigen::Matrix<Scalar, 3, 6>::Zero();
  Scalar weight = 0.0;
  Scalar weight_if_negative = 0.0;  ///< of the first component, the others being zero
  bool is_signed = false;           ///< only then does the second weight count
  std::optional<CouplingId> slack;  ///< of a cable on a pulley: the segment of which the tension is
                                    ///< `slack_share` of that which presses, while that pulls
  double slack_share = 0.0;
};

/// Two bodies of a couple or force between them: that of tail on head, and its opposite.
struct BodyPair {
  BodyId tail;
  BodyId head;
};

/// A reaction that presses too, but for which the file gives no dimension.
enum class Reaction {
  axial,    ///< force along the axis of a journal without thrust_radius
  tilting,  ///< couple across the axis of a journal or guide without length
  torsion,  ///< couple about the axis of a guide without radius
};

/// Its size is |part · wrench of the coupling|.
template <class Scalar>
struct IgnoredPartOf {
  Reaction reaction = Reaction::axial;
  Eigen::Matrix<Scalar, 3, 6> part = Eigen::Matrix<Scalar, 3, 6>::Zero();
};

/// The friction of one coupling in one case, or what a mesh loses: of tail on head `unit` times the
/// magnitude constant + Σ weight |part · wrench of a coupling|, which is never negative. Screws are
/// written about the origin of the Geometry.
template <class Scalar>
struct FrictionLawOf {
  CouplingId coupling;
  std::optional<BodyPair> between;  ///< on which it acts; empty: on the bodies of the coupling
  WrenchOf<Scalar> unit;            ///< against the relative motion, whose power on it is -speed
  Scalar speed = 0.0;               ///< [rad/s or m/s]; negative where a stator drives
  bool is_couple = true;
  Scalar constant = 0.0;  ///< what does not depend on the load [N·m or N]
  bool has_value = true;  ///< at this speed, for which the file may give no drag
  std::vector<PressingPartOf<Scalar>> parts;
  std::vector<IgnoredPartOf<Scalar>> ignored;
  std::optional<int> pushed_by;  ///< of surfaces that part rather than pull: the action, never
                                 ///< negative, of which the magnitude is the first part's weight
};

using PressingPart = PressingPartOf<double>;
using IgnoredPart = IgnoredPartOf<double>;
using FrictionLaw = FrictionLawOf<double>;

/// How the bodies of a torque converter turn about its axis, seen from its stator [rad/s].
template <class Scalar>
struct ConverterTurnsOf {
  Scalar pump = 0.0;
  Scalar turbine = 0.0;
};

/// A coupling with friction and its motion; points and screws from the origin of the Geometry.
template <class Scalar>
struct SlidingOf {
  const Topology& topology;
  const CouplingFrictionOf<Scalar>& friction;
  TwistOf<Scalar> unit;                                   ///< its first freedom
  TwistOf<Scalar> twist;                                  ///< head relative to tail
  Vec3Of<Scalar> at;                                      ///< of the coupling
  std::function<WrenchOf<Scalar>(int)> unit_action = {};  ///< the screw of an action
  ConverterTurnsOf<Scalar> converter = {};                ///< of a torque converter
};

/// Of a coupling whose friction is analysed. The friction has the sense of the motion, however slow
/// that is.
template <class Scalar>
FrictionLawOf<Scalar> make_friction_law(const SlidingOf<Scalar>& sliding);

/// What turns in a torque converter, zero where rounding does not tell it from that.
ConverterTurnsOf<double> converter_turns(const Mechanism& mechanism,
                                         const KinematicSolution& motion,
                                         const CouplingFriction& friction);

/// Whether a coupling at rest has no friction in a case with these known motions; else it has one
/// without direction.
bool is_free_at_rest(const Topology& topology,
                     std::span<const Primary> motions,
                     const CouplingFriction& friction);

/// The laws in a case with that motion, in the order of mechanism.frictions. Empty for a coupling
/// that does not move relative to its tail, as its friction has no direction, and where the file
/// has no drag at that speed. There is none at rest where it is viscous alone, in what engages, and
/// in a case that engages clutches or brakes: these bear all that holds bodies together.
std::vector<std::optional<FrictionLaw>> find_friction_laws(const Mechanism& mechanism,
                                                           const Case& which,
                                                           const KinematicSolution& motion);

}  // namespace kinestat
