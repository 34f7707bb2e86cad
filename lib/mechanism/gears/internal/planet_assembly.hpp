// Whether equal planets can be assembled at equal distances round the main axis.
#pragma once

#include <span>
#include <vector>

namespace kinestat {

/// A mesh in which a planet takes part, with its own teeth and those of its mate; negative of a
/// ring.
struct AssemblyMesh {
  int planet = 0;       ///< index among the planets that are assembled together
  long long teeth = 0;  ///< of the planet
  int mate = -1;        ///< likewise; -1: a gear on the main axis
  long long mate_teeth = 0;
};

/// The numbers of teeth which the count of planets must divide. Of a sun and a ring with a plain
/// planet there is one, z_sun + z_ring; of a stepped planet with a on the sun and b on the ring,
/// (z_sun b + z_ring a)/gcd(a, b).
///
/// In words: from one set of planets to the next, gears on the main axis turn by -1/n in the frame
/// of the planets, planet i by some x_i, both in turns; each mesh then asks that the sum of its two
/// products of teeth and turns be whole. Integer combinations of these conditions, from which all
/// x_i drop out, leave (a sum of teeth)/n whole, and these are all that matters.
std::vector<long long> assembly_teeth(std::span<const AssemblyMesh> meshes, int planet_count);

}  // namespace kinestat
