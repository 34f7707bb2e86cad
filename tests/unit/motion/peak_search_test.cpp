// Peaks of closed forms between steps that miss them.
#include "studies/motion/peak_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

struct Found {
  std::optional<PeakSample> top;
  int looks = 0;
};

Found search(const std::function<double(double)>& value,
             int steps,
             const std::optional<double>& fold) {
  std::vector<PeakSample> known;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    known.push_back({.share = share, .value = value(share)});
  }
  PeakSearch peaks(std::ranges::max(known, {}, &PeakSample::value).value, fold);
  peaks.add_run(known);
  Found found;
  while (const std::optional<double> share = peaks.next()) {
    peaks.take(value(*share));
    ++found.looks;
  }
  found.top = peaks.better();
  return found;
}

// A turn of a crank, drawn at some angle.
double turn(double share, double drawn) {
  return 2.0 * std::numbers::pi * share + drawn;
}

TEST(PeakSearch, ClimbsToTheTopOfASmoothValue) {
  for (const int steps : {36, 72}) {
    for (double drawn = 0.01; drawn < 6.2; drawn += 0.1) {
      const Found found = search(
          [&](double share) {
            const double angle = turn(share, drawn);
            return std::sin(angle) + 0.3 * std::cos(2.0 * angle);
          },
          steps,
          std::nullopt);
      // The slope is zero where sin = 1/1.2.
      ASSERT_TRUE(found.top) << drawn;
      EXPECT_NEAR(found.top->value, 1.0 / 1.2 + 0.3 * (1.0 - 2.0 / 1.44), 1e-11) << drawn;
    }
  }
}

// Of links 2, 5 and 5 and a frame of 6 the angle between coupler and rocker passes 90 degrees.
TEST(PeakSearch, GoesToTheFoldOfAnAngle) {
  for (const int steps : {12, 36, 72}) {
    for (double drawn = 0.01; drawn < 6.2; drawn += 0.1) {
      const Found found = search(
          [&](double share) {
            const double square = 40.0 - 24.0 * std::cos(turn(share, drawn));
            const double angle = std::acos((50.0 - square) / 50.0);
            return std::min(angle, std::numbers::pi - angle);
          },
          steps,
          std::numbers::pi / 2.0);
      ASSERT_TRUE(found.top) << drawn;
      EXPECT_NEAR(found.top->value, std::numbers::pi / 2.0, 2e-12) << drawn;
      EXPECT_NEAR(std::cos(turn(found.top->share, drawn)), -10.0 / 24.0, 1e-9) << drawn;
      EXPECT_LE(found.looks, 12) << drawn;
    }
  }
}

// Below the fold it stays: a top like any other.
TEST(PeakSearch, TakesNoTopBelowAFoldForOne) {
  for (const double top : {60.0, 80.0, 89.0}) {
    for (double drawn = 0.01; drawn < 6.2; drawn += 0.1) {
      const Found found = search(
          [&](double share) { return top - 20.0 + 20.0 * std::sin(turn(share, drawn)); }, 36, 90.0);
      ASSERT_TRUE(found.top) << drawn;
      EXPECT_NEAR(found.top->value, top, 1e-9) << drawn;
    }
  }
}

TEST(PeakSearch, FindsATopBetweenTheLastSteps) {
  const Found first = search([](double share) { return -std::pow(share - 0.03, 2); }, 10, {});
  const Found last = search([](double share) { return -std::pow(share - 0.97, 2); }, 10, {});
  ASSERT_TRUE(first.top && last.top);
  EXPECT_NEAR(first.top->share, 0.03, 1e-12);
  EXPECT_NEAR(last.top->share, 0.97, 1e-12);
}

// So near an end that the three values there fall or rise.
TEST(PeakSearch, FindsATopThatNoStepShows) {
  for (const double at : {0.01, 0.03, 0.97, 0.99}) {
    const Found found = search(
        [&](double share) { return std::cos(2.0 * std::numbers::pi * (share - at)); }, 12, {});
    ASSERT_TRUE(found.top) << at;
    EXPECT_NEAR(found.top->value, 1.0, 1e-12) << at;
  }
}

// The steps beside the one in the middle are of one height, and the cubic is highest aside of it.
TEST(PeakSearch, FindsATopBetweenStepsOfOneHeight) {
  for (const double skew : {0.5, -0.5, 0.01}) {
    const Found found = search(
        [&](double share) {
          const double t = 2.0 * share - 1.0;
          return 1.0 - t * t + skew * (t * t * t - t);
        },
        2,
        std::nullopt);
    // The slope -2 t + skew (3 t^2 - 1) is zero.
    const double t = (1.0 - std::sqrt(1.0 + 3.0 * skew * skew)) / (3.0 * skew);
    ASSERT_TRUE(found.top) << skew;
    EXPECT_NEAR(found.top->value, 1.0 - t * t + skew * (t * t * t - t), 1e-12) << skew;
  }
}

// Two steps of one height, and a third look that happens to be in their middle: there the vertex is
// at that look itself.
TEST(PeakSearch, LooksAsideOfALookInTheMiddle) {
  const auto value = [](double t) { return (t + 1.0) * (1.0 - t) * (2.0 + t); };
  PeakSearch search(0.0, std::nullopt);
  search.add_run(
      PeakTriple{PeakSample{-1.5, value(-1.5)}, PeakSample{-1.0, 0.0}, PeakSample{1.0, 0.0}});
  while (const std::optional<double> share = search.next()) {
    search.take(value(*share));
  }
  // The slope 1 - 4 t - 3 t^2 is zero.
  const double t = (std::sqrt(7.0) - 2.0) / 3.0;
  ASSERT_TRUE(search.better());
  EXPECT_NEAR(search.better()->value, value(t), 1e-12);
}

// Straight on both sides: no parabola comes there, the lines do.
TEST(PeakSearch, GoesToAKink) {
  for (double kink = 0.4001; kink < 0.6; kink += 0.013) {
    const Found found = search(
        [&](double share) { return share < kink ? share - kink : 3.0 * (kink - share); }, 10, {});
    ASSERT_TRUE(found.top) << kink;
    EXPECT_NEAR(found.top->value, 0.0, 1e-13) << kink;
    EXPECT_LE(found.looks, 20) << kink;
  }
}

// The sides of a kink bend, and a top may be narrow beside the steps.
TEST(PeakSearch, ComesToBentKinksAndNarrowTops) {
  for (double kink = 0.4001; kink < 0.6; kink += 0.013) {
    const Found bent = search(
        [&](double share) {
          return -std::abs(std::sin(3.0 * (share - kink)) + (share - kink) * (share - kink));
        },
        10,
        {});
    ASSERT_TRUE(bent.top) << kink;
    EXPECT_NEAR(bent.top->value, 0.0, 1e-9) << kink;
    const Found narrow = search(
        [&](double share) { return 1.0 / (1e-4 + (share - kink) * (share - kink)); }, 10, {});
    ASSERT_TRUE(narrow.top) << kink;
    EXPECT_NEAR(narrow.top->value, 1e4, 1e-6) << kink;
  }
}

TEST(PeakSearch, LooksNowhereOnASlope) {
  const Found found = search([](double share) { return std::exp(share); }, 10, {});
  EXPECT_FALSE(found.top);
  EXPECT_EQ(found.looks, 0);
}

// Where there is no value the climb ends with what it has.
TEST(PeakSearch, EndsWhereThereIsNoValue) {
  PeakSearch peaks(1.0, std::nullopt);
  peaks.add_run(PeakTriple{PeakSample{0.0, 0.5}, PeakSample{0.1, 1.0}, PeakSample{0.2, 0.9}});
  ASSERT_TRUE(peaks.next());
  peaks.take(std::nullopt);
  EXPECT_FALSE(peaks.next());
  EXPECT_FALSE(peaks.better());
}

}  // namespace
}  // namespace kinestat
