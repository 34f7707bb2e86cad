#include <gtest/gtest.h>

#include "mechanism/check/section_checks.hpp"
#include "unit/mechanism/checked_text.hpp"

namespace kinestat {
namespace {

TEST(MotionCheck, AcceptsEveryKey) {
  EXPECT_EQ(complaints_about("motion:\n"
                             "  drives: [{drive: in, to: 360}, {drive: lift, from: -1, to: 5 mm}]\n"
                             "  steps: 36\n"
                             "  case: low\n"
                             "  trace: [{body: block, at: [0, 1, 2]}]\n"
                             "  report: [velocity, s.wz, out]\n"),
            Complaints{});
}

TEST(MotionCheck, ReportsNamesThatAreNotDeclared) {
  EXPECT_EQ(
      complaints_about("motion:\n"
                       "  drive: inn\n"
                       "  to: 1\n"
                       "  case: lwo\n"
                       "  trace: [{body: blok, at: [0, 1, 2]}]\n"
                       "  report: [velocty, q.wz, in, in]\n"),
      (Complaints{"31:10 E0313 'motion' drives actuator 'inn', which is not declared",
                  "33:9 E0313 'motion' takes its speeds from case 'lwo', which is not declared",
                  "34:18 E0312 'trace' of 'motion' follows body 'blok', which is not declared",
                  "35:12 E0313 'report' of 'motion' cannot hold 'velocty'",
                  "35:21 E0313 'report' of 'motion' names coupling 'q', which is not declared",
                  "35:31 E0307 'report' of 'motion' names 'in' twice"}));
}

TEST(MotionCheck, WantsAnglesOfWhatTurnsAndLengthsOfWhatSlides) {
  EXPECT_EQ(
      complaints_about("motion:\n"
                       "  drives: [{drive: in, to: 3 mm}, {drive: lift, from: 1 deg, to: 5}]\n"),
      (Complaints{"31:28 E0309 expected an angle, found a length",
                  "31:55 E0309 expected a length, found an angle"}));
}

TEST(MotionCheck, RefusesADriveThatStaysOrComesTwice) {
  EXPECT_EQ(complaints_about("motion: {drives: [{drive: in, to: 0}, {drive: in, to: 3}]}\n"),
            (Complaints{"30:35 E0305 drive 'in' ends where it begins",
                        "30:47 E0307 'drives' of 'motion' names 'in' twice"}));
}

TEST(MotionCheck, WantsWholeSteps) {
  const auto steps = [](const std::string& number) {
    return complaints_about("motion: {drive: in, to: 1, steps: " + number + "}\n");
  };

  EXPECT_EQ(steps("0"), (Complaints{"30:35 E0305 'steps' of 'motion' cannot be 0"}));
  EXPECT_EQ(steps("36.5"), (Complaints{"30:35 E0305 'steps' of 'motion' cannot be 36.5"}));
  EXPECT_EQ(steps("-1"), (Complaints{"30:35 E0305 'steps' of 'motion' cannot be -1"}));
  EXPECT_EQ(steps("1e7"), (Complaints{"30:35 E0305 'steps' of 'motion' cannot be 1e7"}));
}

}  // namespace
}  // namespace kinestat
