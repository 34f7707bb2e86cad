#include <gtest/gtest.h>

#include "format/sections/sections.hpp"
#include "support/read_section.hpp"

namespace kinestat {
namespace {

auto motion_of(const std::string& text, Space space = Space::planar) {
  return read_section(motion_section(), "'motion'", text, space);
}

TEST(MotionSection, ReadsTheSmallestSection) {
  const auto reading = motion_of("drive: in\nto: 360 deg\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const MotionDescription& motion = *reading.value;
  ASSERT_EQ(motion.drives.size(), 1U);
  EXPECT_EQ(motion.drives[0].actuator.text, "in");
  EXPECT_FALSE(motion.drives[0].from);
  EXPECT_EQ(motion.drives[0].to->expression.text(), "360 deg");
  EXPECT_FALSE(motion.steps);
  EXPECT_FALSE(motion.label);
}

TEST(MotionSection, ReadsEveryKey) {
  const auto reading = motion_of(
      "drives: [{drive: in, from: 0, to: 90 deg}, {drive: lift, to: 5 mm}]\n"
      "steps: 36\n"
      "case: design point\n"
      "trace: [{body: rod, at: [3, 4]}]\n"
      "report: [velocity, d.wz]\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const MotionDescription& motion = *reading.value;
  ASSERT_EQ(motion.drives.size(), 2U);
  EXPECT_EQ(motion.drives[1].actuator.text, "lift");
  EXPECT_EQ(motion.steps->expression.text(), "36");
  EXPECT_EQ(motion.label->text, "design point");
  EXPECT_EQ(motion.trace[0].body.text, "rod");
  EXPECT_EQ(motion.trace[0].at.coordinates.size(), 2U);
  EXPECT_EQ(motion.report[1].text, "d.wz");
}

TEST(MotionSection, NeedsADriveAndItsEnd) {
  EXPECT_EQ(motion_of("steps: 10\n").complaints(),
            (Complaints{"1:1 E0303 'motion' lacks the key 'drive'",
                        "1:1 E0303 'motion' lacks the key 'to'"}));
  EXPECT_EQ(motion_of("drives: [{from: 1}]\n").complaints(),
            (Complaints{"1:10 E0303 drive 1 of 'motion' lacks the key 'drive'"}));
  EXPECT_EQ(motion_of("drives: [{drive: a}, {drive: b, to: 1}]\n").complaints(),
            (Complaints{"1:10 E0303 drive 1 of 'motion' lacks the key 'to'"}));
  EXPECT_EQ(motion_of("drives: [{drive: a}, {drive: b}]\ntime: 2\n").complaints(), Complaints{});
}

TEST(MotionSection, RefusesOneDriveBesideSeveral) {
  EXPECT_EQ(motion_of("drives: [{drive: a, to: 1}]\ndrive: b\nto: 3\n").complaints(),
            (Complaints{"2:1 E0302 'motion' cannot have 'drive' together with 'drives'",
                        "3:1 E0302 'motion' cannot have 'to' together with 'drives'"}));
}

TEST(MotionSection, ReportsWrongShapesAtTheirPlaces) {
  EXPECT_EQ(motion_of("drives: []\n").complaints(),
            (Complaints{"1:9 E0304 'drives' of 'motion' must be a list with something in it"}));
  EXPECT_EQ(motion_of("drive: a\nto: 1\ntrace: {body: rod, at: [1, 2]}\nspeed: 3\n").complaints(),
            (Complaints{"3:8 E0304 'trace' of 'motion' must be a list",
                        "4:1 E0302 'motion' has no key 'speed'"}));
}

TEST(MotionSection, WantsTracePointsOfTheSpace) {
  EXPECT_EQ(
      motion_of("drive: a\nto: 1\ntrace: [{body: rod, at: [1, 2]}, {bdy: rod, at: [1, 2, 3]}]\n",
                Space::spatial)
          .complaints(),
      (Complaints{"3:25 E0304 'at' of trace point 1 has 2 components, spatial space needs 3",
                  "3:35 E0302 trace point 2 has no key 'bdy'"}));
}

}  // namespace
}  // namespace kinestat
