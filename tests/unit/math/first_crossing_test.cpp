// Dips and changes of sign of closed forms.
#include "math/dense/first_crossing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// A parabola of least value `bottom` at a place, and where it first becomes zero.
struct Dip {
  double place = 0.0;
  double bottom = 0.0;

  double operator()(double x) const { return (x - place) * (x - place) + bottom; }

  double first_zero() const { return place - std::sqrt(-bottom); }
};

// But nearer to an end than the looks beside it.
TEST(FirstCrossing, IsSeenInADipWhereverItLies) {
  for (const double bottom : {-0.04, -1e-4, -1e-8}) {
    for (double place = 0.003; place < 1.0; place += 0.0171) {
      const Dip dip{.place = place, .bottom = bottom};
      if (dip(0.0) <= 0.0 || dip(1.0) <= 0.0) {
        continue;
      }
      for (const int parts : {1, 2, 4}) {
        if (std::min(place, 1.0 - place) < 1.0 / (64.0 * parts)) {
          continue;
        }
        const auto found = find_crossing(dip, 0.0, 1.0, parts);
        ASSERT_TRUE(found) << place << " " << bottom << " " << parts;
        EXPECT_LE(found->before, dip.first_zero()) << place;
        EXPECT_GE(dip(found->before), 0.0) << place;
        EXPECT_LT(dip(found->behind), 0.0) << place;
      }
    }
  }
}

TEST(FirstCrossing, IsNoneWhereADipEndsAboveOrAtZero) {
  for (const double bottom : {0.1, 1e-6, 0.0}) {
    for (double place = 0.003; place < 1.0; place += 0.0171) {
      EXPECT_FALSE(find_crossing(Dip{.place = place, .bottom = bottom}, 0.0, 1.0, 4)) << place;
    }
  }
}

TEST(FirstCrossing, IsThatOfAValueThatStaysNegative) {
  for (const double zero : {0.001, 0.3, 0.999}) {
    const auto found = find_crossing([=](double x) { return zero - x; }, 0.0, 1.0, 4);
    ASSERT_TRUE(found) << zero;
    EXPECT_LE(found->before, zero);
    EXPECT_GT(found->behind, zero);
  }
}

TEST(FirstCrossing, LooksOnBehindAGap) {
  const auto found = find_crossing(
      [](double x) { return x > 0.2 && x < 0.6 ? std::nullopt : std::optional(0.9 - x); },
      0.0,
      1.0,
      4);
  ASSERT_TRUE(found);
  EXPECT_LE(found->before, 0.9);
  EXPECT_GT(found->behind, 0.9);
}

}  // namespace
}  // namespace kinestat
