// Places between rows at which a friction slides another way than in these, of closed forms.
#include "studies/motion/task/friction_places.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

using Speed = std::function<double(double)>;

Mechanism one_friction() {
  Mechanism mechanism;
  mechanism.frictions.emplace_back();
  mechanism.frictions.back().mu = 0.1;
  return mechanism;
}

// The rows at whole steps, and the places that are found between them.
std::vector<double> found_between(int steps,
                                  const Speed& speed,
                                  const MotionPlan& plan = {},
                                  const std::function<bool(double)>& stands = {}) {
  const auto sliding = [&](double step) {
    FrictionSliding found{.rates = {Vec3(speed(step), 0.0, 0.0)}};
    found.stands = stands && stands(step);
    return found;
  };
  std::vector<FrictionPlace> places;
  for (int i = 0; i <= steps; ++i) {
    places.push_back({.step = static_cast<double>(i),
                      .row = static_cast<std::size_t>(i),
                      .sliding = sliding(i)});
  }
  add_places_between(
      one_friction(),
      plan,
      {.speeds = [&](double step) { return std::vector<Vec3>{Vec3(speed(step), 0.0, 0.0)}; },
       .place = [&](double step) { return std::optional(sliding(step)); }},
      places);
  EXPECT_TRUE(std::ranges::is_sorted(places, {}, &FrictionPlace::step));
  std::vector<double> between;
  for (const FrictionPlace& one : places) {
    if (!one.row) {
      between.push_back(one.step);
    }
  }
  return between;
}

TEST(FrictionPlaces, AreNoneWhereRowsShowEachTurn) {
  EXPECT_TRUE(found_between(24, [](double at) { return std::cos(0.2618 * at + 0.1); }).empty());
  EXPECT_TRUE(found_between(24, [](double) { return 2.0; }).empty());
}

// A parabola that is below zero from 7.2 to 7.6 alone.
TEST(FrictionPlaces, LieInAShortStretchOfTheOtherSense) {
  const auto between = found_between(24, [](double at) { return (at - 7.2) * (at - 7.6); });
  ASSERT_EQ(between.size(), 1U);
  EXPECT_GT(between[0], 7.2);
  EXPECT_LT(between[0], 7.6);
}

// A cubic that is zero at 7.3, 7.5 and 7.6: between these two stretches.
TEST(FrictionPlaces, LieInBothStretchesBetweenThreeTurns) {
  const auto between =
      found_between(24, [](double at) { return (at - 7.3) * (at - 7.5) * (at - 7.6); });
  ASSERT_EQ(between.size(), 2U);
  EXPECT_GT(between[0], 7.3);
  EXPECT_LT(between[0], 7.5);
  EXPECT_GT(between[1], 7.5);
  EXPECT_LT(between[1], 7.6);
}

TEST(FrictionPlaces, LieBetweenRowsThatBothRest) {
  const auto between = found_between(12, [](double at) { return (at - 5.0) * (at - 6.0); });
  ASSERT_EQ(between.size(), 1U);
  EXPECT_DOUBLE_EQ(between[0], 5.5);
}

// Out and back in the fourth of five steps, with rests before and behind: where the drive stops,
// and the middle of each stroke.
TEST(FrictionPlaces, ShowStrokesBetweenTwoRests) {
  MotionPlan plan;
  plan.drives.push_back({.actuator = 0, .freedom = 0, .from = 0.0, .to = 0.0, .where = {}});
  plan.steps = 5;
  DriveCourse course;
  course.parts = {{.begin = 0.0, .end = 0.64, .from = 0.0, .to = 0.0},
                  {.begin = 0.64, .end = 0.68, .from = 0.0, .to = 1.0, .law = DriveLaw::cycloidal},
                  {.begin = 0.68, .end = 0.72, .from = 1.0, .to = 0.0, .law = DriveLaw::cycloidal},
                  {.begin = 0.72, .end = 1.0, .from = 0.0, .to = 0.0}};
  plan.schedule.emplace(1.0, std::vector<DriveCourse>{course});
  const auto speed = [&](double at) { return plan.schedule->at(0, at / 5.0).speed; };
  const auto between = found_between(5, speed, plan, [&](double at) { return speed(at) == 0.0; });
  const std::vector<double> expected = {3.2, 3.3, 3.4, 3.5, 3.6};
  ASSERT_EQ(between.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(between[i], expected[i], 1e-12);
  }
}

}  // namespace
}  // namespace kinestat
