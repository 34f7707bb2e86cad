// Frictions as functions of each other, and their solution followed from none to all.
#pragma once

#include <optional>
#include <vector>

#include "core/types.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

/// |constant + Σ f_j slopes_j| times a weight.
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

}  // namespace kinestat
