#include "studies/transmissions/teeth_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

using Place = std::array<double, 2>;

Place at(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

double distance(const Place& a, const Place& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

// Centres in modules; the angle between the planets of a pair is that of their triangle.
void expect_assembled(SetKind kind, const SetTeeth& set) {
  const double turn = 2.0 * std::numbers::pi / set.planets;
  if (kind == SetKind::simple) {
    EXPECT_EQ(set.sun + 2 * set.planet, set.ring);
    EXPECT_EQ((set.sun + set.ring) % set.planets, 0);
    const double radius = (set.sun + set.planet) / 2.0;
    EXPECT_GT(distance(at(radius, 0.0), at(radius, turn)), set.planet + 2.0);
    return;
  }
  EXPECT_EQ((set.ring - set.sun) % set.planets, 0);
  const double inner = (set.sun + set.planet) / 2.0;
  const double outer = (set.ring - set.planet) / 2.0;
  double from = 0.0;
  double to = turn / 2.0;
  ASSERT_LT(std::abs(outer - inner), set.planet);
  for (int i = 0; i < 60; ++i) {
    const double angle = (from + to) / 2.0;
    (distance(at(inner, 0.0), at(outer, angle)) < set.planet ? from : to) = angle;
  }
  EXPECT_NEAR(distance(at(inner, 0.0), at(outer, from)), set.planet, 1e-9);
  EXPECT_GT(distance(at(inner, 0.0), at(inner, turn)), set.planet + 2.0);
  EXPECT_GT(distance(at(outer, 0.0), at(outer, turn)), set.planet + 2.0);
  EXPECT_GT(distance(at(inner, turn), at(outer, from)), set.planet + 2.0);
  EXPECT_GT(outer, (set.sun + set.planet) / 2.0 + 2.0);
  EXPECT_LT(inner, (set.ring - set.planet) / 2.0 - 2.0);
}

TEST(TeethChoice, KnownSetsAreTheSmallest) {
  // 30 + 2 * 21 = 72; of less teeth with 72/30 only 25 and 60 is odd, and 20 and 48 has planets
  // of 14.
  const SetTeeth set = choose_teeth(SetKind::simple, 2.4, {});
  EXPECT_EQ(set.sun, 30);
  EXPECT_EQ(set.planet, 21);
  EXPECT_EQ(set.ring, 72);
  EXPECT_EQ(set.planets, 3);
}

TEST(TeethChoice, PlanetsCanBeAssembledAndDoNotTouch) {
  for (const SetKind kind : {SetKind::simple, SetKind::double_planet}) {
    for (int thousandths = 1060; thousandths <= 10'000; thousandths += 37) {
      SCOPED_TRACE(thousandths);
      const double ratio = thousandths / 1000.0;
      const SetTeeth set = choose_teeth(kind, ratio, {});
      EXPECT_LE(std::abs(set.stationary_ratio() - ratio), 1e-3 + 1e-12);
      EXPECT_GE(set.sun, 18);
      EXPECT_GE(set.planet, 15);
      expect_assembled(kind, set);
    }
  }
}

// By going through suns, rings and planets one by one.
TEST(TeethChoice, RatiosOfTeethAreThoseOfSetsWithinTheLimits) {
  const TeethLimits limits{.least_sun = 18,
                           .largest_sun = 32,
                           .least_ring = 54,
                           .largest_ring = 70,
                           .least_planet = 15,
                           .planets = {4, 3}};
  for (const SetKind kind : {SetKind::simple, SetKind::double_planet}) {
    const std::vector<double> ratios = ratios_of_teeth(kind, limits);
    ASSERT_FALSE(ratios.empty());
    EXPECT_TRUE(std::ranges::is_sorted(ratios));
    for (const double ratio : ratios) {
      const SetTeeth set = choose_teeth(kind, ratio, limits);
      EXPECT_EQ(set.stationary_ratio(), ratio);
      EXPECT_TRUE(set.sun >= 18 && set.sun <= 32 && set.ring >= 54 && set.ring <= 70);
      EXPECT_GE(set.planet, 15);
      EXPECT_TRUE(set.planets == 3 || set.planets == 4);
      expect_assembled(kind, set);
    }
  }
  std::set<double> simple;
  for (int sun = 18; sun <= 32; ++sun) {
    for (int planet = 15; sun + 2 * planet <= 70; ++planet) {
      const int ring = sun + 2 * planet;
      for (const int count : {3, 4}) {
        const double radius = (sun + planet) / 2.0;
        const double apart = distance(at(radius, 0.0), at(radius, 2.0 * std::numbers::pi / count));
        if (ring >= 54 && (sun + ring) % count == 0 && apart > planet + 2.0) {
          simple.insert(static_cast<double>(ring) / sun);
        }
      }
    }
  }
  EXPECT_EQ(ratios_of_teeth(SetKind::simple, limits),
            std::vector<double>(simple.begin(), simple.end()));
}

}  // namespace
}  // namespace kinestat
