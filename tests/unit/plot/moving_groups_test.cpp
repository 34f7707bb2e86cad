#include <vector>

#include <gtest/gtest.h>

#include "core/contract.hpp"
#include "draw/svg.hpp"
#include "unit/plot/picture_text.hpp"

namespace kinestat {
namespace {

const Cycle kEven = {.seconds = 4.0, .times = {0.0, 0.5, 1.0}};

std::string moving(const GroupMotion& motion, const Cycle& cycle = kEven) {
  Svg svg;
  svg.open_moving_group("crank", {}, motion, cycle);
  svg.close_group();
  return svg.elements();
}

std::string passing(const std::vector<bool>& is_seen, const Cycle& cycle) {
  Svg svg;
  svg.open_passing_group({}, is_seen, cycle);
  svg.close_group();
  return svg.elements();
}

TEST(MovingGroup, TurnsAboutItsPivotAndShiftsWithIt) {
  const std::string text =
      moving({.pivot = {.x = 10, .y = 20},
              .shifts = {{.x = 0, .y = 0}, {.x = 5, .y = -1.25}, {.x = 0, .y = 0}},
              .turns = {0.0, 90.0, 180.0}});

  EXPECT_EQ(text,
            "<g><title>crank</title>\n"
            "<animateTransform attributeName=\"transform\" type=\"translate\" dur=\"4s\" "
            "repeatCount=\"indefinite\" values=\"0 0;5 -1.25;0 0\"/>\n"
            "<animateTransform attributeName=\"transform\" type=\"rotate\" additive=\"sum\" "
            "dur=\"4s\" repeatCount=\"indefinite\" values=\"0 10 20;90 10 20;180 10 20\"/>\n"
            "</g>\n");
}

TEST(MovingGroup, StandsAsAtItsFirstKeyFrameWithoutMotion) {
  const std::string text = moving({.pivot = {.x = 10, .y = 20},
                                   .shifts = {{.x = 3, .y = 4}, {.x = 5, .y = 6}, {.x = 3, .y = 4}},
                                   .turns = {-30.0, 0.0, -30.0}});

  EXPECT_TRUE(has(text, "<g transform=\"translate(3 4) rotate(-30 10 20)\">")) << text;
}

// What does not shift has nothing on top of which it turns.
TEST(MovingGroup, LeavesOutWhatDoesNotMove) {
  const std::vector<PixelPoint> still(3);
  const std::string turns =
      moving({.pivot = {.x = 1, .y = 2}, .shifts = still, .turns = {0, 180, 360}});
  const std::string shifts = moving({.pivot = {.x = 1, .y = 2},
                                     .shifts = {{.x = 0, .y = 0}, {.x = 7, .y = 0}, {}},
                                     .turns = {0, 0, 0}});

  EXPECT_FALSE(has(turns, "translate"));
  EXPECT_FALSE(has(turns, "additive"));
  EXPECT_TRUE(has(turns, "values=\"0 1 2;180 1 2;360 1 2\""));
  EXPECT_FALSE(has(shifts, "rotate"));
  EXPECT_FALSE(has(moving({.pivot = {}, .shifts = still, .turns = {0, 0, 0}}), "animate"));
}

// A translation that is animated takes the place of all that stands in the group.
TEST(MovingGroup, KeepsATurnThatDoesNotChange) {
  const std::string text = moving({.pivot = {.x = 1, .y = 2},
                                   .shifts = {{.x = 0, .y = 0}, {.x = 7, .y = 0}, {}},
                                   .turns = {45, 45, 45}});

  EXPECT_TRUE(has(text, "type=\"rotate\" additive=\"sum\"")) << text;
}

TEST(MovingGroup, SaysTheTimesThatAreNotEven) {
  const GroupMotion motion = {
      .pivot = {}, .shifts = std::vector<PixelPoint>(3), .turns = {0, 90, 360}};

  EXPECT_FALSE(has(moving(motion), "keyTimes"));
  EXPECT_TRUE(has(moving(motion, {.seconds = 2.5, .times = {0.0, 0.25, 1.0}}),
                  "dur=\"2.5s\" repeatCount=\"indefinite\" keyTimes=\"0;0.25;1\""));
}

// 1000 turns and a quarter look like a quarter.
TEST(MovingGroup, TurnsNoFasterThanCanBeSeen) {
  const std::string text = moving(
      {.pivot = {}, .shifts = std::vector<PixelPoint>(3), .turns = {0.0, 360090.0, 360180.0}});

  EXPECT_TRUE(has(text, "values=\"0 0 0;90 0 0;180 0 0\"")) << text;
}

// The last of them is the first again, and without motion in between nothing is seen of it.
TEST(MovingGroup, GoesStepwiseWhereTheCycleDoes) {
  const GroupMotion motion = {
      .pivot = {}, .shifts = std::vector<PixelPoint>(3), .turns = {0, 90, 360}};

  EXPECT_TRUE(has(moving(motion, {.seconds = 4.0, .times = {0.0, 0.5, 1.0}, .is_stepwise = true}),
                  "calcMode=\"discrete\" dur=\"4s\" repeatCount=\"indefinite\" "
                  "values=\"0 0 0;90 0 0\""));
  EXPECT_TRUE(has(moving(motion, {.seconds = 4.0, .times = {0.0, 0.2, 1.0}, .is_stepwise = true}),
                  "keyTimes=\"0;0.2\" values=\"0 0 0;90 0 0\""));
}

// A disc of radius 2 about (7, 0) that turns about the origin by right angles, and then shifts.
TEST(MovingGroup, LiesWhereItComes) {
  Svg svg;
  const Cycle cycle = {.seconds = 4.0, .times = {0.0, 0.25, 0.5, 1.0}};
  svg.open_moving_group(
      {},
      {},
      {.pivot = {}, .shifts = {{}, {}, {.x = 0, .y = 30}, {}}, .turns = {0.0, 90.0, 180.0, 360.0}},
      cycle);
  svg.circle({.x = 7, .y = 0}, 2.0, {.stroke = Ink::none});
  svg.close_group();

  EXPECT_NEAR(svg.bounds().left, -9.0, 1e-12);
  EXPECT_NEAR(svg.bounds().right, 9.0, 1e-12);
  EXPECT_NEAR(svg.bounds().top, -2.0, 1e-12);
  EXPECT_NEAR(svg.bounds().bottom, 32.0, 1e-12);
}

TEST(MovingGroup, HasAValueForEachTime) {
  EXPECT_THROW((void)moving({.pivot = {}, .shifts = {{}, {}}, .turns = {0.0, 1.0}}),
               ContractViolation);
}

TEST(PassingGroup, IsSeenFromAKeyFrameUntilTheNext) {
  const Cycle cycle = {.seconds = 4.0, .times = {0.0, 0.2, 0.6, 1.0}};

  EXPECT_EQ(passing({false, true, false, false}, cycle),
            "<g display=\"none\">\n"
            "<animate attributeName=\"display\" calcMode=\"discrete\" dur=\"4s\" "
            "repeatCount=\"indefinite\" keyTimes=\"0;0.2;0.6\" values=\"none;inline;none\"/>\n"
            "</g>\n");
  EXPECT_TRUE(has(passing({false, false, true, false}, cycle),
                  "keyTimes=\"0;0.6\" values=\"none;inline\""));
}

TEST(PassingGroup, IsSeenWithoutMotionIfItIsTheFirst) {
  const std::string text = passing({true, false, true}, {.seconds = 1.0, .times = {0.0, 0.5, 1.0}});

  EXPECT_TRUE(has(text, "<g>"));
  EXPECT_TRUE(has(text, "keyTimes=\"0;0.5\" values=\"inline;none\"")) << text;
}

TEST(PassingGroup, IsSeenTwiceThereAndBack) {
  EXPECT_TRUE(has(passing({false, true, false, true, false},
                          {.seconds = 1.0, .times = {0.0, 0.25, 0.5, 0.75, 1.0}}),
                  "keyTimes=\"0;0.25;0.5;0.75\" values=\"none;inline;none;inline\""));
}

}  // namespace
}  // namespace kinestat
