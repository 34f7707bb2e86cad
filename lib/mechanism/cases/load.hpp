// Loads bound to numbers: what acts on bodies from outside.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/source.hpp"
#include "screw/bounded_screw.hpp"

namespace kinestat {

/// An action on a body that equilibrium takes as known. The wrench [N·m; N] is written about the
/// origin of the Geometry.
struct BodyWrench {
  BodyId body;
  Wrench wrench;
};

/// Before the body, in the name of its weight.
inline constexpr std::string_view kWeightPrefix = "gravity.";

/// Likewise, of its force of inertia.
inline constexpr std::string_view kInertiaPrefix = "inertia.";

/// Likewise, of the force of a spring, which may be followed by a dot and the body.
inline constexpr std::string_view kSpringPrefix = "spring.";

/// A load of a case: one that the file names, the weight of a body, named
/// gravity.BODY, or its force of inertia, named inertia.BODY.
struct Load {
  std::string name;
  BodyWrench acts;
  std::optional<Vec3> point;  ///< where the force acts [m]; empty for a couple alone
  SourceRange where;
};

/// The couple of a load beside its force, which acts at its point [N·m]; what is rounding of the
/// moment of the force is zero.
inline Vec3 couple_of(const Load& load) {
  return load.point ? moment_at(written(load.acts.wrench), *load.point).zeroed()
                    : load.acts.wrench.moment;
}

/// What the loads do to the bodies, without their names.
inline std::vector<BodyWrench> wrenches_of(std::span<const Load> loads) {
  std::vector<BodyWrench> wrenches;
  wrenches.reserve(loads.size());
  for (const Load& load : loads) {
    wrenches.push_back(load.acts);
  }
  return wrenches;
}

}  // namespace kinestat
