#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/gears/internal/mesh_loss_binder.hpp"
#include "unit/mechanism/checked_text.hpp"

namespace kinestat {
namespace {

// Two meshes with teeth, one of them with a ring.
const std::string kTrain =
    "kinestat: 1\n"
    "space: planar\n"
    "ground: housing\n"
    "bodies: [sun, planet, ring, carrier]\n"
    "couplings:\n"
    "  p: {type: revolute, bodies: [carrier, planet], at: [0, 25]}\n"
    "  s: {type: gear, bodies: [sun, planet], at: [0, 10], tangent: x, pressure_angle: 0.3}\n"
    "  r: {type: gear, bodies: [ring, planet], at: [0, 40], tangent: x, pressure_angle: 0.3,\n"
    "      internal: true}\n"
    "gears:\n"
    "  module: 1\n"
    "  members: {S: {body: sun, teeth: 20}, P: {body: planet, teeth: 30},\n"
    "            R: {body: ring, teeth: 80, internal: true}}\n"
    "  meshes: {s: {members: [S, P], carrier: carrier}, r: {members: [R, P], carrier: carrier}}\n";

struct BoundLosses {
  Diagnostics found;
  std::vector<LossyMesh> meshes;

  explicit BoundLosses(const std::string& losses, const std::string& train = kTrain) {
    const auto root = read_yaml({.path = "test.yaml", .text = train + losses}, ReadLimits{}, found);
    const auto description = root ? read_mechanism(*root, found) : std::nullopt;
    EXPECT_TRUE(description.has_value());
    if (description) {
      Evaluator evaluator = make_evaluator(*description, found);
      meshes = bind_losses(*description, evaluator, found);
    }
  }

  double share(std::size_t i) const { return i < meshes.size() ? meshes[i].share : NAN; }
};

TEST(LossBinder, TakesTheKindOfEachMesh) {
  const BoundLosses bound("losses: {gear_external: 0.02, gear_internal: {eta: 0.99}}\n");

  ASSERT_EQ(bound.meshes.size(), 2U);
  EXPECT_EQ(bound.meshes[0].coupling, CouplingId{1});
  EXPECT_EQ(bound.share(0), 0.02);
  EXPECT_NEAR(bound.share(1), 0.01, 1e-16);
}

TEST(LossBinder, PrefersTheLossOfTheMeshItself) {
  const BoundLosses bound("losses: {gear_external: 0.02, meshes: {s: {loss: 0.015}}}\n");

  ASSERT_EQ(bound.meshes.size(), 1U);
  EXPECT_EQ(bound.share(0), 0.015);
}

// A loss of nothing makes an efficiency of one; where no loss is given there is none.
TEST(LossBinder, KeepsMeshesThatLoseNothing) {
  const BoundLosses bound("losses: {gear_external: 0, gear_internal: {eta: 1}}\n");

  EXPECT_EQ(bound.share(0), 0.0);
  EXPECT_EQ(bound.share(1), 0.0);
  EXPECT_TRUE(BoundLosses("losses: {}\n").meshes.empty());
}

// k (1/20 + 1/30) and k (1/30 - 1/80).
TEST(LossBinder, FindsLossesFromTeeth) {
  const BoundLosses bound("losses: {gear_external: {k: 0.24}, gear_internal: {k: 0.24}}\n");

  EXPECT_NEAR(bound.share(0), 0.02, 1e-16);
  EXPECT_NEAR(bound.share(1), 0.005, 1e-16);
}

TEST(LossBinder, RefusesTeethThatLeaveNothing) {
  const BoundLosses bound("losses: {gear_external: {k: 12}}\n");

  EXPECT_EQ(complaints_of(bound.found),
            (Complaints{"15:29 E0305 'k' of the loss of mesh 's' cannot be 12: with its teeth the "
                        "mesh would lose 1 of its power"}));
}

TEST(LossBinder, FindsNoTeethOnAGearWrittenByHand) {
  const std::size_t gears = kTrain.find("gears:");
  const BoundLosses bound("losses: {gear_external: {k: 0.2}}\n", kTrain.substr(0, gears));

  EXPECT_EQ(complaints_of(bound.found),
            (Complaints{"10:29 E0303 mesh 's' has no teeth to find its loss from"}));
}

}  // namespace
}  // namespace kinestat
