// Linkages with masses, as both sides of a benchmark are made of them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace kinestat::bench {

// What this header says is C++ 17, which Simbody needs.

using Components = std::array<double, 3>;

enum class JointKind { revolute, prismatic, universal, spherical };

/// World frame, drawn position [m]. Body 0 is the ground, which comes first.
struct LinkageJoint {
  JointKind kind = JointKind::revolute;
  int tail = 0;
  int head = 0;
  Components at = {};
  Components axis = {0.0, 0.0, 1.0};         ///< unit vector; of a universal joint that in the tail
  Components second_axis = {1.0, 0.0, 0.0};  ///< of a universal joint that in the head
  bool closes = false;                       ///< a circuit, so that it is no branch of the tree
};

/// One kilogram, at a point, with the same moment of inertia about all axes.
struct LinkageBody {
  Components centre = {};  ///< [m]
  double inertia = 0.0;    ///< [kg·m²]
};

/// Moves from where it is drawn at constant speed of its drives, all alike, under its weight.
struct MassLinkage {
  std::string name;
  bool is_planar = false;
  std::vector<LinkageBody> bodies = {};  ///< without the ground
  std::vector<LinkageJoint> joints = {};
  std::vector<std::size_t> drives = {};  ///< joints
  double stroke = 0.0;                   ///< of each drive [rad or m]
  double speed = 0.0;                    ///< [rad/s or m/s]
};

/// 9.81 m/s^2 against y in the plane, against z in space.
Components gravity_on(const MassLinkage& linkage);

/// A four-bar, a Watt six-bar, a spatial crank and rocker, a platform on six legs.
std::vector<MassLinkage> mass_linkages();

/// As a file of the program, with that many steps; without inertia only the weights load it. Joint
/// i is called ji, the case c.
std::string file_text(const MassLinkage& linkage, bool has_inertia, int steps);

}  // namespace kinestat::bench
