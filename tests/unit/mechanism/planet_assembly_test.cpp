#include "mechanism/gears/internal/planet_assembly.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

using Teeth = std::vector<long long>;

// A planet on a sun and in a ring.
Teeth plain_set(long long sun, long long planet, long long ring) {
  const std::vector<AssemblyMesh> meshes = {
      {.planet = 0, .teeth = planet, .mate = -1, .mate_teeth = sun},
      {.planet = 0, .teeth = planet, .mate = -1, .mate_teeth = -ring}};
  return assembly_teeth(meshes, 1);
}

TEST(PlanetAssembly, OfAPlainSetAsksForSunAndRing) {
  EXPECT_EQ(plain_set(24, 18, 60), Teeth{84});
  EXPECT_EQ(plain_set(30, 23, 78), Teeth{108});
}

// Müller, Epicyclic Drive Trains, 1982: (z_sun b + z_ring a)/gcd(a, b) of a stepped planet.
TEST(PlanetAssembly, OfASteppedPlanetAsksForTheProductsByTheCommonDivisor) {
  const std::vector<AssemblyMesh> meshes = {
      {.planet = 0, .teeth = 24, .mate = -1, .mate_teeth = 20},
      {.planet = 0, .teeth = 18, .mate = -1, .mate_teeth = -70}};

  EXPECT_EQ(assembly_teeth(meshes, 1), Teeth{(20 * 18 + 70 * 24) / 6});
}

// Between sun and ring stand two planets, which turn against each other: ring minus sun.
TEST(PlanetAssembly, OfPairedPlanetsAsksForRingLessSun) {
  const std::vector<AssemblyMesh> meshes = {
      {.planet = 0, .teeth = 20, .mate = -1, .mate_teeth = 34},
      {.planet = 0, .teeth = 20, .mate = 1, .mate_teeth = 26},
      {.planet = 1, .teeth = 26, .mate = -1, .mate_teeth = -82}};

  EXPECT_EQ(assembly_teeth(meshes, 2), Teeth{82 - 34});
}

TEST(PlanetAssembly, OfARavigneauxSetAsksForBothSuns) {
  const std::vector<AssemblyMesh> meshes = {
      {.planet = 0, .teeth = 20, .mate = -1, .mate_teeth = 34},
      {.planet = 0, .teeth = 20, .mate = 1, .mate_teeth = 26},
      {.planet = 1, .teeth = 26, .mate = -1, .mate_teeth = 29},
      {.planet = 1, .teeth = 26, .mate = -1, .mate_teeth = -82}};
  const Teeth teeth = assembly_teeth(meshes, 2);

  const auto fits = [&](long long count) { return teeth[0] % count == 0 && teeth[1] % count == 0; };
  ASSERT_EQ(teeth.size(), 2U);
  for (const long long count : {2, 3, 4, 5, 6, 7}) {
    EXPECT_EQ(fits(count), (82 - 34) % count == 0 && (82 + 29) % count == 0) << count;
  }
}

TEST(PlanetAssembly, OfOneMeshAsksForNothing) {
  const std::vector<AssemblyMesh> mesh = {{.planet = 0, .teeth = 18, .mate = -1, .mate_teeth = 24}};

  EXPECT_EQ(assembly_teeth(mesh, 1), Teeth{});
}

}  // namespace
}  // namespace kinestat
