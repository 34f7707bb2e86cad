// What equal planets at equal angles do with their inertia, where one of them is drawn.
#pragma once

#include <optional>

#include "dynamics/body_inertia.hpp"
#include "dynamics/inertial_motion.hpp"

namespace kinestat {

/// The axis of the body that carries equal planets, which stand around it at equal angles.
struct PlanetAxis {
  BodyId carrier;
  Vec3 direction = Vec3::UnitZ();  ///< a unit vector
  Vec3 point = Vec3::Zero();       ///< on it [m]
};

/// Of a planet, where the mechanism stands; empty where its carrier turns about several.
std::optional<PlanetAxis> axis_of_planets(const Mechanism& mechanism, BodyId planet);

/// The wrench of inertia of all planets at their places, of the one that `drawn` is of them
/// together at the place of one: turned about the axis of their carrier by every share of a turn,
/// what is across that axis cancels. Empty where the axis itself turns over.
std::optional<BoundedWrench> spread_planets(const BoundedWrench& drawn,
                                            const PlanetAxis& axis,
                                            const BodyInertia& planets,
                                            const InertialMotion& motion);

}  // namespace kinestat
