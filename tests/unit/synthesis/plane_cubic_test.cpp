#include "synthesis/plane_cubic.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// (u² + v²)(u + 2 v) - 3 u v = 0: a loop through the origin, which is a node.
const PlaneCubic kNodal{.k = {1.0, 2.0}, .q = {0.0, -3.0, 0.0}, .l = {0.0, 0.0}, .c = 0.0};

// (u² + v² - 1)(u - 3)
const PlaneCubic kCircleAndLine{
    .k = {1.0, 0.0}, .q = {-3.0, 0.0, -3.0}, .l = {-1.0, 0.0}, .c = 3.0};

// u (u² + v²) - u + 0.1: an oval and a branch with the asymptote u = 0.
const PlaneCubic kOvalAndBranch{.k = {1.0, 0.0}, .q = {0.0, 0.0, 0.0}, .l = {-1.0, 0.0}, .c = 0.1};

double turning_of(const CurveBranch& branch) {
  double length = 0.0;
  for (std::size_t i = 1; i < branch.points.size(); ++i) {
    length += std::abs(branch.points[i] - branch.points[i - 1]);
  }
  return length;
}

TEST(PlaneCubic, HasItsFocusOnIt) {
  EXPECT_LT(kNodal.miss(*kNodal.focus()), 1e-15);
}

// In polar coordinates r = 3 sin cos / (cos + 2 sin); along e = (-2, 1)/√5 the quadratic terms are
// -3 (-2)(1)/5, so that the asymptote is (u + 2 v) = -6/5.
TEST(PlaneCubic, HasItsAsymptote) {
  const PlaneLine line = *kNodal.asymptote();

  EXPECT_NEAR(line.offset, -1.2 / std::sqrt(5.0), 1e-15);
  EXPECT_NEAR(cross(line.normal, {1.0, 2.0}), 0.0, 1e-15);
}

TEST(PlaneCubic, MayBeWrittenAboutAnotherCentre) {
  const PlaneCubic moved = kNodal.about({-1.5, 0.7}, 4.0);

  for (const double angle : {0.3, 1.1, 1.4}) {
    const double r =
        3.0 * std::sin(angle) * std::cos(angle) / (std::cos(angle) + 2.0 * std::sin(angle));
    EXPECT_LT(moved.miss(std::polar(r, angle)), 1e-15);
  }
  EXPECT_LT(std::abs(*moved.focus() - *kNodal.focus()), 1e-15);
}

TEST(PlaneCubic, OfCircleAndLineIsSampledAsBoth) {
  const auto branches = sample(kCircleAndLine, {0.0, 0.0}, 5.0, 200);

  ASSERT_EQ(branches.size(), 2U);
  const auto closed = std::ranges::find(branches, true, &CurveBranch::is_closed);
  ASSERT_NE(closed, branches.end());
  EXPECT_NEAR(turning_of(*closed), 2.0 * M_PI, 0.01);
  const auto open = std::ranges::find(branches, false, &CurveBranch::is_closed);
  EXPECT_NEAR(turning_of(*open), 8.0, 1e-12);
}

TEST(PlaneCubic, OfTwoBranchesIsSampledAsTwo) {
  const auto branches = sample(kOvalAndBranch, {0.0, 0.0}, 3.0, 300);

  EXPECT_EQ(std::ranges::count(branches, true, &CurveBranch::is_closed), 1);
  for (const CurveBranch& branch : branches) {
    for (const Point& point : branch.points) {
      EXPECT_LT(kOvalAndBranch.miss(point), 1e-12);
      EXPECT_LE(std::abs(point), 3.0 + 1e-9);
    }
  }
}

TEST(PlaneCubic, IsSampledWithoutHoles) {
  for (const CurveBranch& branch : sample(kNodal, {0.0, 0.0}, 4.0, 2000)) {
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
      EXPECT_LT(std::abs(branch.points[i] - branch.points[i - 1]), 0.2);
    }
  }
}

}  // namespace
}  // namespace kinestat
