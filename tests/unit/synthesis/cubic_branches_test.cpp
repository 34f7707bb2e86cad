#include "studies/synthesis/curves/cubic_branches.hpp"

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

TEST(CubicBranches, OfCircleAndLineAreBoth) {
  const auto branches = sample(kCircleAndLine, {0.0, 0.0}, 5.0, 200);

  ASSERT_EQ(branches.size(), 2U);
  const auto closed = std::ranges::find(branches, true, &CurveBranch::is_closed);
  ASSERT_NE(closed, branches.end());
  EXPECT_NEAR(turning_of(*closed), 2.0 * M_PI, 0.01);
  const auto open = std::ranges::find(branches, false, &CurveBranch::is_closed);
  EXPECT_NEAR(turning_of(*open), 8.0, 1e-12);
}

TEST(CubicBranches, OfOvalAndBranchAreTwo) {
  const auto branches = sample(kOvalAndBranch, {0.0, 0.0}, 3.0, 300);

  EXPECT_EQ(std::ranges::count(branches, true, &CurveBranch::is_closed), 1);
  for (const CurveBranch& branch : branches) {
    for (const Point& point : branch.points) {
      EXPECT_LT(kOvalAndBranch.miss(point), 1e-12);
      EXPECT_LE(std::abs(point), 3.0 + 1e-9);
    }
  }
}

TEST(CubicBranches, HaveNoHoles) {
  for (const CurveBranch& branch : sample(kNodal, {0.0, 0.0}, 4.0, 2000)) {
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
      EXPECT_LT(std::abs(branch.points[i] - branch.points[i - 1]), 0.2);
    }
  }
}

}  // namespace
}  // namespace kinestat
