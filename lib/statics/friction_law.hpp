// What friction a coupling has, as a function of the actions that it bears.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// A part of a reaction that presses the surfaces together: its share of the friction is a weight
/// times |part · wrench|. A part with one component may have another weight if it is negative. Of
/// parts that press instead of each other, the one with the largest share counts alone. `Scalar` is
/// double or Dual.
template <class Scalar>
struct PressingPartOf {
  std::optional<CouplingId> of;  ///< the coupling whose wrench presses; empty: the law's own
  std::vector<CountedCoupling> beside = {};  ///< whose wrenches are added to that
  Eigen::Matrix<Scalar, 3, 6> part = Eigen::Matrix<Scalar, 3, 6>::Zero();
  Scalar weight = 0.0;
  Scalar weight_if_negative = 0.0;  ///< of the first component, the others being zero
  bool is_signed = false;           ///< whether weight_if_negative counts
  bool is_instead = false;          ///< presses instead of the part before it where its share is
                                    ///< larger: the other strand of a cable on a pulley
  std::optional<CouplingId> slack;  ///< of a cable that slips: the segment with the lower tension,
                                    ///< which is `slack_share` times the tension that presses
  double slack_share = 0.0;
};

/// The two bodies between which a couple or force acts: the tail acts on the head, and the head
/// with the opposite on the tail.
struct BodyPair {
  BodyId tail;
  BodyId head;
};

/// A reaction that presses too, but causes no friction because the file lacks a dimension for it.
enum class Reaction {
  axial,    ///< force along the axis of a journal without thrust_radius
  tilting,  ///< couple across the axis of a journal or guide without length
  torsion,  ///< couple about the axis of a guide without radius
};

/// A reaction that is ignored; its size is |part · wrench of the coupling with those `beside`|.
template <class Scalar>
struct IgnoredPartOf {
  Reaction reaction = Reaction::axial;
  std::vector<CountedCoupling> beside = {};
  Eigen::Matrix<Scalar, 3, 6> part = Eigen::Matrix<Scalar, 3, 6>::Zero();
};

/// The friction of one coupling in one case, or the loss of a mesh. The tail acts on the head with
/// `unit` times the magnitude constant + Σ weight |part · wrench of a coupling|, which is never
/// negative. Screws are written about the origin of the Geometry.
template <class Scalar>
struct FrictionLawOf {
  CouplingId coupling;
  std::optional<BodyPair> between;  ///< the bodies on which it acts; empty: those of the coupling
  WrenchOf<Scalar> unit;            ///< against the relative motion, on which its power is -speed
  Scalar speed = 0.0;               ///< [rad/s or m/s]; negative where a stator drives
  bool is_couple = true;
  Scalar constant = 0.0;  ///< the part of the magnitude that no load changes [N·m or N]
  bool has_value = true;  ///< false if the file gives no drag for this speed
  std::vector<PressingPartOf<Scalar>> parts;
  std::vector<IgnoredPartOf<Scalar>> ignored;
  std::optional<int> pushed_by;  ///< of surfaces that can only push: their normal force, never
                                 ///< negative, times which the first weight is the friction
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

/// A coupling with friction and its motion. Points and screws refer to the origin of the Geometry.
template <class Scalar>
struct SlidingOf {
  const Topology& topology;
  const CouplingFrictionOf<Scalar>& friction;
  TwistOf<Scalar> unit;                                   ///< its first freedom
  TwistOf<Scalar> twist;                                  ///< head relative to tail
  Vec3Of<Scalar> at;                                      ///< of the coupling
  std::function<WrenchOf<Scalar>(int)> unit_action = {};  ///< the screw of an action
  ConverterTurnsOf<Scalar> converter = {};                ///< of a torque converter
  std::function<bool(CouplingId)> slips = {};  ///< whether a cable does on that virtual link
};

/// Makes the law of a coupling whose friction is analysed. The friction opposes the motion, however
/// slow that is.
template <class Scalar>
FrictionLawOf<Scalar> make_friction_law(const SlidingOf<Scalar>& sliding);

/// The speeds of pump and turbine of a torque converter; zero if rounding does not distinguish them
/// from zero.
ConverterTurnsOf<double> converter_turns(const Mechanism& mechanism,
                                         const KinematicSolution& motion,
                                         const CouplingFriction& friction);

/// Whether a coupling at rest has no friction in a case with these known motions. Otherwise it has
/// friction whose direction is not known.
bool is_free_at_rest(const Topology& topology,
                     std::span<const Primary> motions,
                     const CouplingFriction& friction);

/// Finds the friction laws in a case with this motion, in the order of mechanism.frictions. A law
/// is empty if the coupling is at rest, because its friction then has no direction, and if the file
/// gives no drag at its speed. The friction at rest is zero instead if is_free_at_rest holds: for
/// viscous friction, for clutches and brakes, and in a case that engages clutches or brakes, since
/// these then hold the bodies together.
std::vector<std::optional<FrictionLaw>> find_friction_laws(const Mechanism& mechanism,
                                                           const Case& which,
                                                           const KinematicSolution& motion);

}  // namespace kinestat
