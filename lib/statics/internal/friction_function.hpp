// Frictions as functions of each other, and their solution followed from none to all.
#pragma once

#include <optional>
#include <vector>

#include "core/types.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

/// |constant + Σ f_j slopes_j| times a weight; the largest of those that press instead of each
/// other.
struct PressingForce {
  Vec3 constant = Vec3::Zero();
  Eigen::Matrix<double, 3, Eigen::Dynamic> slopes;
  const PressingPart* part = nullptr;
};

/// The friction of a coupling as a function of all frictions.
struct FrictionFunction {
  double constant = 0.0;
  std::vector<PressingForce> forces;
};

/// Where f = share · functions(f) is solved, the share of the friction growing from 0 to 1. Empty
/// if the friction grows beyond all bounds on the way.
std::optional<VecX> follow_friction(const std::vector<FrictionFunction>& functions);

/// Another solution of f = functions(f) than that one, if a search finds it. There is none where
/// frictions change each other by less than they change, however they press. Sought are those in
/// which some of what presses in the first presses the other way, or of a cable on a pulley the
/// other strand; of a single friction none is missed, for it is a convex function of itself, but
/// one in which the strand ahead would push.
std::optional<VecX> find_other_friction(const std::vector<FrictionFunction>& functions,
                                        const VecX& f);

/// A further condition on frictions: constant + slopes · f = 0.
struct FrictionCondition {
  double constant = 0.0;
  VecX slopes;
};

/// Of as many functions as there are frictions, but for the last magnitude, which is none and which
/// the condition determines: the solution that Newton's method finds from `start`.
std::optional<VecX> solve_friction(const std::vector<FrictionFunction>& functions,
                                   const FrictionCondition& condition,
                                   VecX start);

}  // namespace kinestat
