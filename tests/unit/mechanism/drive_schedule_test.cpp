#include "mechanism/drive_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

struct Peaks {
  DriveLaw law;
  double speed;         // over range/time
  double acceleration;  // over range/time²
};

// Norton, Design of Machinery, chapter 8; of the polynomials from their derivatives.
const Peaks kPeaks[] = {{DriveLaw::constant_acceleration, 2.0, 4.0},
                        {DriveLaw::trapezoid, 1.5, 4.5},
                        {DriveLaw::polynomial_345, 15.0 / 8.0, 10.0 / std::sqrt(3.0)},
                        {DriveLaw::polynomial_4567, 35.0 / 16.0, 7.513188404399},
                        {DriveLaw::cycloidal, 2.0, 2.0 * kHalfTurn},
                        {DriveLaw::harmonic, kHalfTurn / 2.0, kHalfTurn* kHalfTurn / 2.0},
                        {DriveLaw::modified_trapezoid, 2.0, 8.0 * kHalfTurn / (kHalfTurn + 2.0)},
                        {DriveLaw::modified_sine,
                         4.0 * kHalfTurn / (kHalfTurn + 4.0),
                         4.0 * kHalfTurn* kHalfTurn / (kHalfTurn + 4.0)}};

TEST(DriveLaw, has_the_peaks_of_the_literature) {
  for (const Peaks& one : kPeaks) {
    double speed = 0.0;
    double acceleration = 0.0;
    for (int i = 0; i <= 100'000; ++i) {
      const LawPoint point = law_at(one.law, kUsualRamp, i / 1e5);
      speed = std::max(speed, point.slope);
      acceleration = std::max(acceleration, point.bend);
    }
    EXPECT_NEAR(speed, one.speed, 1e-9) << static_cast<int>(one.law);
    EXPECT_NEAR(acceleration, one.acceleration, 1e-6) << static_cast<int>(one.law);
  }
}

// By central differences of the share and of the slope.
TEST(DriveLaw, has_the_derivatives_of_its_share) {
  constexpr double kStep = 1e-5;
  for (int law = 0; law <= static_cast<int>(DriveLaw::modified_sine); ++law) {
    for (int i = 1; i < 37; ++i) {
      const double u = i / 37.0;  // no place where a law changes its formula
      const auto at = [&](double time) {
        return law_at(static_cast<DriveLaw>(law), kUsualRamp, time);
      };
      const LawPoint before = at(u - kStep);
      const LawPoint after = at(u + kStep);
      EXPECT_NEAR((after.share - before.share) / (2.0 * kStep), at(u).slope, 1e-8)
          << law << ' ' << u;
      EXPECT_NEAR((after.slope - before.slope) / (2.0 * kStep), at(u).bend, 1e-7)
          << law << ' ' << u;
    }
  }
}

TEST(DriveLaw, begins_and_ends_with_the_range) {
  for (int law = 0; law <= static_cast<int>(DriveLaw::modified_sine); ++law) {
    const auto at = [&](double time) { return law_at(static_cast<DriveLaw>(law), 0.25, time); };
    EXPECT_EQ(at(0.0).share, 0.0);
    EXPECT_EQ(at(1.0).share, 1.0);
    EXPECT_NEAR(at(0.5).share, 0.5, 1e-15) << law;
  }
}

// The first and the last tenth of the time speed up and slow down: 1/(0.1 · 0.9).
TEST(DriveLaw, has_the_acceleration_behind_a_jump) {
  EXPECT_EQ(law_at(DriveLaw::trapezoid, 0.1, 0.1).bend, 0.0);
  EXPECT_EQ(law_at(DriveLaw::trapezoid, 0.1, 0.3 - 0.2).bend, 0.0);
  EXPECT_NEAR(law_at(DriveLaw::trapezoid, 0.1, 0.9).bend, -1.0 / 0.09, 1e-12);
  EXPECT_NEAR(law_at(DriveLaw::trapezoid, 1.0 / 3.0, 2.0 / 3.0).bend, -4.5, 1e-12);
  EXPECT_EQ(law_at(DriveLaw::constant_acceleration, 0.1, 0.5 - 1e-16).bend, -4.0);
}

TEST(DriveSchedule, runs_straight_in_proportion_without_turning_back) {
  const DriveSchedule straight(
      2.0, {{.from = 0, .to = 4, .speed = 2}, {.from = 1, .to = -1, .speed = -1}});
  EXPECT_TRUE(straight.is_straight());
  const DriveSchedule unlike(
      2.0, {{.from = 0, .to = 4, .speed = 2}, {.from = 0, .to = 4, .speed = 0, .acceleration = 2}});
  EXPECT_FALSE(unlike.is_straight());
  const DriveSchedule back(2.0, {{.from = 0, .to = 0, .speed = 2, .acceleration = -2}});
  EXPECT_FALSE(back.is_straight());
  EXPECT_EQ(back.at(0, 0.5).position, 1.0);
  EXPECT_EQ(back.at(0, 1.0).speed, -2.0);
}

// s = (v t + a t²/2)/range, solved for t by hand.
TEST(DriveSchedule, tells_the_time_of_a_place) {
  const DriveSchedule schedule(2.0, {{.from = 1, .to = 7, .speed = 1, .acceleration = 2}});
  EXPECT_TRUE(schedule.is_straight());
  EXPECT_NEAR(schedule.time_of(2.0 / 6.0), 0.5, 1e-15);
  EXPECT_EQ(schedule.time_of(1.0), 1.0);
}

// A way of 4 in the first quarter, then a dwell, then back within a quarter, then rest.
TEST(DriveSchedule, dwells_and_rests_where_its_parts_end) {
  using enum DriveLaw;
  const DriveSchedule schedule(
      8.0,
      {{.from = 1,
        .to = 1,
        .parts = {{.begin = 0.0, .end = 0.25, .from = 1, .to = 5, .law = harmonic},
                  {.begin = 0.25, .end = 0.5, .from = 5, .to = 5},
                  {.begin = 0.5, .end = 0.75, .from = 5, .to = 1, .law = constant_speed}}}});

  EXPECT_FALSE(schedule.is_straight());
  EXPECT_NEAR(schedule.at(0, 0.125).position, 3.0, 1e-15);
  EXPECT_NEAR(schedule.at(0, 0.125).speed, 4.0 / 2.0 * std::numbers::pi / 2.0, 1e-15);
  EXPECT_EQ(schedule.at(0, 0.25).position, 5.0);
  EXPECT_EQ(schedule.at(0, 0.375).speed, 0.0);
  EXPECT_EQ(schedule.at(0, 0.625).position, 3.0);
  EXPECT_EQ(schedule.at(0, 0.625).speed, -2.0);
  EXPECT_EQ(schedule.at(0, 0.75).position, 1.0);
  EXPECT_EQ(schedule.at(0, 1.0).position, 1.0);
  EXPECT_EQ(schedule.at(0, 1.0).speed, 0.0);
  EXPECT_EQ(schedule.jumps(), (std::vector<double>{0.5, 0.75}));
}

// 0.1 + 0.2 is another double than 0.3.
TEST(DriveSchedule, tells_jumps_of_two_drives_at_one_time_once) {
  const auto jumps_at = [](double time) {
    return DriveCourse{
        .from = 1, .to = 2, .parts = {{.begin = time, .to = 1, .law = DriveLaw::constant_speed}}};
  };

  const DriveSchedule schedule(1.0, {jumps_at(0.1 + 0.2), jumps_at(0.3)});

  EXPECT_EQ(schedule.jumps(), (std::vector<double>{0.3, 1.0}));
}

TEST(DriveSchedule, tells_the_corners_of_its_laws) {
  const DriveSchedule schedule(
      1.0,
      {{.from = 0.0,
        .to = 1.0,
        .parts = {
            {.begin = 0.0, .end = 0.2, .from = 0.0, .to = 0.0},
            {.begin = 0.2, .end = 0.6, .from = 0.0, .to = 1.0, .law = DriveLaw::modified_sine},
            {.begin = 0.6,
             .end = 1.0,
             .from = 1.0,
             .to = 0.0,
             .law = DriveLaw::constant_acceleration}}}});
  const std::vector<double> expected = {0.2, 0.25, 0.55, 0.6, 0.8};
  const std::vector<double> corners = schedule.corners();
  ASSERT_EQ(corners.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(corners[i], expected[i], 1e-12);
  }
}

}  // namespace
}  // namespace kinestat
