// What a mechanism does at one point of a duty.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

/// Of what turns freely beside a gear.
inline constexpr double kUnknownSpeed = std::numeric_limits<double>::quiet_NaN();

/// A gear of a mesh, seen from its carrier; neither number is negative.
struct GearState {
  double speed = 0.0;                  ///< [rad/s]
  std::optional<double> torque = 0.0;  ///< of the teeth about its axis [N·m]; 0 where it does not
                                       ///< turn, empty where equilibrium leaves it open
};

struct MeshState {
  GearState head;
  GearState tail;
};

/// Magnitudes with all losses, SI. Powers are those that the mechanism is given: what is lost is
/// negative.
struct DutyState {
  std::vector<double> rates = {};                   ///< of each freedom, or kUnknownSpeed
  std::vector<std::optional<double>> actions = {};  ///< of each action; empty where it is open
  std::vector<double> actuators = {};               ///< power of each [W]
  std::vector<double> loads = {};     ///< of the loads of the case, of a spring as one without its
                                      ///< damping [W]
  std::vector<double> dampers = {};   ///< of the damping of each spring [W]; or none
  std::vector<double> friction = {};  ///< of each of mechanism.frictions [W]
  std::vector<double> meshes = {};    ///< of each of mechanism.lossy_meshes [W]
  std::vector<MeshState> teeth = {};  ///< of each mesh; zero where it has no carrier
  std::vector<std::optional<Vec3>> forces = {};  ///< that each coupling bears [N]; likewise
  bool drives_from_both_ends = false;            ///< losses take more than the inputs give
  std::string no_efficiency = {};  ///< why what is taken is no measure; empty if it is
};

}  // namespace kinestat
