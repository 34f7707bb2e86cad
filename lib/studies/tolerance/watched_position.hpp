// A position of which errors are told: of a freedom, of a point, or of a body that turns.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "expression/quantity.hpp"
#include "mechanism/mechanism.hpp"
#include "mechanism/motion_plan.hpp"

namespace kinestat {

/// A component of the displacement of a body: of its point there, or else of its rotation.
struct BodyDisplacement {
  BodyId body;
  Vec3 direction = Vec3::UnitX();  ///< unit vector, world frame
  std::optional<Vec3> at = {};     ///< from the geometry's origin [m]
};

/// A position that small errors of parts and drives move.
struct WatchedPosition {
  std::string name;                            ///< "d.wz", "P/at/x", "coupler/rotation/z"
  QuantityKind kind = QuantityKind::length;    ///< or an angle
  std::variant<int, BodyDisplacement> of = 0;  ///< index into Topology::freedoms, or of a body
};

/// Those of a name: a freedom, an actuator, a point of the section `motion`, a body, or one
/// component of these two, as "P/at/x". None if nothing is called so.
std::vector<WatchedPosition> watched_positions(const Mechanism& mechanism,
                                               std::span<const TracedPoint> points,
                                               std::string_view name);

/// What one wants to know if nothing is named: of the actuators that are not held, and of the
/// points; of all freedoms where there are none.
std::vector<WatchedPosition> usual_positions(const Mechanism& mechanism,
                                             std::span<const TracedPoint> points,
                                             const Case& which);

/// What `watched_positions` knows, for a hint.
std::vector<std::string> watched_names(const Mechanism& mechanism,
                                       std::span<const TracedPoint> points);

}  // namespace kinestat
