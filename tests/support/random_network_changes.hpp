// The changes of a random network that must not change its answers.
#pragma once

#include "support/random_network.hpp"

namespace kinestat {

/// A random spanning tree instead of the default one.
RandomNetwork with_another_tree(RandomNetwork network, std::uint64_t seed);

/// About half of the edges point the other way; `reversed[e]` says which. What belongs to the tail
/// and what to the head changes places: the axes of a universal, the ends of a cable. All other
/// screws stay as they are, the lines of action of teeth too, so that their magnitudes change sign.
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

/// Within the plane for a planar network; a translation alone where names fix directions.
RigidMotion make_random_motion(const RandomNetwork& network, std::uint64_t seed);

/// Directions along the axes of the world become vectors, unless the motion is a translation.
RandomNetwork moved(RandomNetwork network, const RigidMotion& motion);

/// All lengths times `factor`.
RandomNetwork scaled(RandomNetwork network, double factor);

}  // namespace kinestat
