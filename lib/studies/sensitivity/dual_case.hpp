// The screws of a solved case as functions of its unknowns and of the parameters.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/bind/derivatives.hpp"
#include "statics/friction_law.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Every number is a dual with derivatives towards all rates, then all actions, all frictions and
/// the parameters, as if these were independent of each other; the adjoint brings them together.
class DualCase {
 public:
  /// `motion` is null unless solved, `action` unless it has magnitudes; one with friction needs the
  /// motion. `derivatives` are those of the mechanism. All must outlive the object.
  DualCase(const Mechanism& mechanism,
           std::size_t case_index,
           const KinematicSolution* motion,
           const StaticSolution* action,
           const MechanismDerivatives& derivatives);

  const Mechanism& mechanism() const { return mechanism_; }

  const Topology& topology() const { return mechanism_.topology; }

  const Case& which() const { return mechanism_.cases[case_index_]; }

  const KinematicSolution* motion() const { return motion_; }

  const StaticSolution* action() const { return action_; }

  const MechanismDerivatives& derivatives() const { return derivatives_; }

  /// The slopes of what the case knows.
  const CaseDerivatives& primaries() const { return derivatives_.cases[case_index_]; }

  std::size_t parameter_count() const { return derivatives_.parameter_count; }

  /// Of the couplings that have any.
  std::size_t friction_count() const { return laws_.size(); }

  /// Rates, actions, frictions and parameters together; these come last.
  std::size_t variable_count() const { return first_parameter() + parameter_count(); }

  std::size_t first_parameter() const;

  Dual rate(std::size_t freedom) const;

  /// Empty where the magnitude is open.
  std::optional<Dual> magnitude(std::size_t action) const;

  /// Empty also where it is a convention (least norm), which no power or ratio is made of.
  std::optional<Dual> real_magnitude(std::size_t action) const;

  /// Tail on head, about the origin of the geometry, as the next ones are.
  WrenchOf<Dual> unit_action(std::size_t action) const;

  /// Of a coupling that moves against friction. It knows the rates, but no actions.
  FrictionLawOf<Dual> law_of(CouplingId coupling) const;

  /// In the order of the frictions of the solution.
  const FrictionLawOf<Dual>& friction_law(std::size_t friction) const { return laws_[friction]; }

  Dual friction(std::size_t friction) const;
  WrenchOf<Dual> friction_wrench(std::size_t friction) const;

  /// Head relative to tail, about the origin of the geometry.
  TwistOf<Dual> coupling_twist(std::size_t coupling) const;

  /// The sum of what the couplings have along the branches of the spanning tree from the ground,
  /// each positive from tail to head.
  TwistOf<Dual> along_tree(std::size_t body,
                           const std::function<TwistOf<Dual>(std::size_t)>& of_coupling) const;

  TwistOf<Dual> body_twist(std::size_t body) const;

  /// The actions and the friction of tail on head, about the origin of the geometry; empty if one
  /// of its actions is open.
  std::optional<WrenchOf<Dual>> coupling_wrench(std::size_t coupling) const;

  /// Of a load of the case, about the origin of the geometry.
  WrenchOf<Dual> load_wrench(std::size_t load) const;

  /// Of a coupling, in the world [m].
  Vec3Of<Dual> point(std::size_t coupling) const;

  /// Of a body, in the world [m].
  Vec3Of<Dual> reference(std::size_t body) const;

 private:
  // The branch over which the tree reaches a body, and whether along it.
  struct Step {
    int coupling = -1;
    bool forward = true;
  };

  Dual placed(const Dual& dimension) const;
  Vec3Of<Dual> placed(const Vec3Of<Dual>& vector) const;
  WrenchOf<Dual> placed(const WrenchOf<Dual>& wrench) const;
  TwistOf<Dual> unit_motion(std::size_t freedom) const;

  const Mechanism& mechanism_;
  std::size_t case_index_;
  const KinematicSolution* motion_;
  const StaticSolution* action_;
  const MechanismDerivatives& derivatives_;
  std::vector<Step> steps_;                ///< of each body; none for the ground
  std::vector<FrictionLawOf<Dual>> laws_;  ///< of each friction of the solution
};

}  // namespace kinestat
