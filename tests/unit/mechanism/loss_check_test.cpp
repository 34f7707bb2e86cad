#include <gtest/gtest.h>

#include "mechanism/gears/internal/mesh_loss_binder.hpp"
#include "unit/mechanism/checked_text.hpp"

namespace kinestat {
namespace {

const std::string kGears =
    "gears: {module: 1, members: {x: {body: sun, teeth: 9}, y: {body: planet, teeth: 9}},\n"
    "        meshes: {h: {members: [x, y], carrier: carrier}}}\n";

TEST(LossCheck, AcceptsSharesOfThePower) {
  EXPECT_EQ(
      complaints_about(
          kGears + "losses: {gear_external: 0, gear_internal: {eta: 1}, meshes: {h: {k: 0.2}}}\n"),
      Complaints{});
}

TEST(LossCheck, RefusesSharesThatCannotBe) {
  EXPECT_EQ(complaints_about(kGears + "losses:\n"
                                      "  gear_external: 1\n"
                                      "  gear_internal: {eta: 0}\n"
                                      "  meshes: {h: {loss: -0.1}}\n"),
            (Complaints{"33:18 E0305 'gear_external' of 'losses' cannot be 1",
                        "34:24 E0305 'eta' of 'gear_internal' of 'losses' cannot be 0",
                        "35:22 E0305 the loss of mesh 'h' cannot be -0.1"}));
}

TEST(LossCheck, RefusesAPercentage) {
  EXPECT_EQ(complaints_about(kGears + "losses: {gear_external: 2, meshes: {h: {k: -1}}}\n"),
            (Complaints{"32:25 E0305 'gear_external' of 'losses' cannot be 2",
                        "32:44 E0305 'k' of the loss of mesh 'h' cannot be -1"}));
}

TEST(LossCheck, KnowsMeshesAndCouplingsApart) {
  const Diagnostics found = check_of(gear_set(kGears + "losses: {meshes: {hh: 0.1, a: 0.1}}\n"));

  EXPECT_EQ(complaints_of(found),
            (Complaints{"32:19 E0313 'losses' names mesh 'hh', which is not declared",
                        "32:28 E0313 'losses' names coupling 'a', which is not a mesh"}));
  EXPECT_EQ(
      found.items()[1].hint,
      "a bearing or slider has 'friction:' in 'couplings', for example a: {…, friction: 0.1}");
}

TEST(LossCheck, FindsNoTeethOnAGearWrittenByHand) {
  EXPECT_EQ(complaints_of(check_of(
                "kinestat: 1\n"
                "space: planar\n"
                "ground: frame\n"
                "bodies: [p, q]\n"
                "couplings:\n"
                "  a: {type: revolute, bodies: [frame, p], at: [0, 0]}\n"
                "  b: {type: revolute, bodies: [frame, q], at: [0, 2]}\n"
                "  g: {type: gear, bodies: [p, q], at: [0, 1], tangent: x, pressure_angle: 0.3}\n"
                "losses: {meshes: {g: {k: 0.2}}}\n")),
            (Complaints{"9:26 E0303 mesh 'g' has no teeth to find its loss from"}));
}

TEST(LossCheck, TakesOnlyMeshesOfGears) {
  const Diagnostics found = check_of(
      "kinestat: 1\n"
      "space: planar\n"
      "ground: frame\n"
      "bodies: [p, bar]\n"
      "couplings:\n"
      "  a: {type: revolute, bodies: [frame, p], at: [0, 0]}\n"
      "  b: {type: prismatic, bodies: [frame, bar], axis: x}\n"
      "  r: {type: rack, bodies: [p, bar], at: [0, 1], line_of_action: x}\n"
      "losses: {meshes: {r: 0.02}}\n");

  EXPECT_EQ(
      complaints_of(found),
      (Complaints{"9:19 E0313 'losses' names 'r', a rack; only meshes of gears lose a share of "
                  "their power"}));
}

}  // namespace
}  // namespace kinestat
