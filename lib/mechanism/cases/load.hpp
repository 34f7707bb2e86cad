// Loads, which act on bodies from outside, bound to numbers.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/source.hpp"
#include "description/load_description.hpp"
#include "screw/bounded_screw.hpp"

namespace kinestat {

/// A known wrench on a body [N·m; N], written about the origin of the Geometry.
struct BodyWrench {
  BodyId body;
  Wrench wrench;
};

/// Prefix of the name of the weight of a body.
inline constexpr std::string_view kWeightPrefix = "gravity.";

/// Prefix of the name of the inertia force of a body.
inline constexpr std::string_view kInertiaPrefix = "inertia.";

/// Prefix of the name of the force of a spring; a dot and the body may follow the spring.
inline constexpr std::string_view kSpringPrefix = "spring.";

/// A load of a case: one that the file names, the weight of a body (gravity.BODY), its inertia
/// force (inertia.BODY), or the force of a spring (spring.NAME).
struct Load {
  std::string name;
  BodyWrench acts;
  std::optional<Vec3> point;  ///< where the force acts [m]; empty for a couple alone
  LoadFrame frame = LoadFrame::world;
  SourceRange where;
};

/// The couple of a load in addition to its force, which acts at the point of the load [N·m].
/// Components within the rounding of the moment of the force are zero.
inline Vec3 couple_of(const Load& load) {
  return load.point ? moment_at(written(load.acts.wrench), *load.point).zeroed()
                    : load.acts.wrench.moment;
}

/// The wrenches of the loads, with their bodies but without their names.
inline std::vector<BodyWrench> wrenches_of(std::span<const Load> loads) {
  std::vector<BodyWrench> wrenches;
  wrenches.reserve(loads.size());
  for (const Load& load : loads) {
    wrenches.push_back(load.acts);
  }
  return wrenches;
}

}  // namespace kinestat
