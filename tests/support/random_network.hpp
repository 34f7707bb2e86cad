// Random mechanisms from a seed, and the changes that must not change their answers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace kinestat {

struct NetworkCoupling {
  std::string name;
  CouplingType type = CouplingType::revolute;
  int tail = 0;
  int head = 0;
  Vec3 at = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();            ///< of any length
  std::string keyword;                  ///< "x", "-z", …; empty: the vector is written
  Vec3 line_of_action = Vec3::UnitX();  ///< of a gear
};

/// How the points and axes of a spatial network lie; all but `general` make redundant constraints.
enum class Layout {
  general,
  lattice,          ///< small whole coordinates, axes along x, y, z
  parallel_axes,    ///< every axis along one direction
  planar_in_space,  ///< a planar linkage in an oblique plane
  spherical,        ///< every axis through one point
  planar            ///< space: planar
};

struct NetworkActuator {
  std::string name;
  std::string coupling;
};

/// What a file would say. Bodies are b0 (the ground), b1, …; `body_order` is the order of the
/// moving ones in the file.
struct RandomNetwork {
  Space space = Space::spatial;
  Layout layout = Layout::general;
  std::vector<int> body_order;
  std::vector<NetworkCoupling> couplings;
  std::vector<NetworkActuator> actuators;
  std::vector<std::string> tree;  ///< empty: the default one

  int body_count() const { return static_cast<int>(body_order.size()) + 1; }
};

/// 3 to 30 bodies with at least one circuit. Even seeds have passive couplings with f + c = λ
/// alone (and actuators); odd seeds also gears, clutches and brakes.
RandomNetwork make_random_network(std::uint64_t seed);

/// The text of the mechanism file.
std::string to_yaml(const RandomNetwork& network);

/// Through the reader and the binder; a complaint of either is a failed test and an empty
/// mechanism.
Mechanism bind_network(const RandomNetwork& network);

/// A random spanning tree instead of the default one.
RandomNetwork with_another_tree(RandomNetwork network, std::uint64_t seed);

/// About half of the edges point the other way; `reversed[e]` says which.
RandomNetwork with_reversed_edges(RandomNetwork network,
                                  std::uint64_t seed,
                                  std::vector<bool>& reversed);

/// The moving bodies in another order.
RandomNetwork with_renumbered_bodies(RandomNetwork network, std::uint64_t seed);

/// A point x of the world goes to rotation · x + translation.
struct RigidMotion {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 translation = Vec3::Zero();

  Twist operator*(const Twist& twist) const;
  Wrench operator*(const Wrench& wrench) const;
};

/// Within the plane for a planar network.
RigidMotion make_random_motion(Space space, std::uint64_t seed);

RandomNetwork moved(RandomNetwork network, const RigidMotion& motion);

/// All lengths times `factor`.
RandomNetwork scaled(RandomNetwork network, double factor);

}  // namespace kinestat
