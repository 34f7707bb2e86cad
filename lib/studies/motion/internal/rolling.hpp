// How teeth roll in the body that holds their axes apart.
#pragma once

#include <optional>
#include <span>

#include "mechanism/gears/hinge_lines.hpp"
#include "mechanism/gears/mesh.hpp"
#include "studies/motion/motion_network.hpp"

namespace kinestat {

/// The relation of turns of a coupling with teeth, over the joints of a network whose tree is
/// built; empty where no body has both motions on fixed lines. `lines` are those of all hinges,
/// `meshes` those of the mechanism.
std::optional<RollingRow> find_rolling(const Mechanism& mechanism,
                                       const MotionNetwork& network,
                                       std::span<const HingeLine> lines,
                                       std::span<const Mesh> meshes,
                                       CouplingId coupling);

}  // namespace kinestat
