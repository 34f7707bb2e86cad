#include <gtest/gtest.h>

#include "math/dense/least_squares.hpp"
#include "support/near.hpp"

namespace kinestat {
namespace {

// Aᵀ A = [5 2; 2 2], whose inverse is [2 -2; -2 5]/6.
TEST(NormalEquations, AreSolvedForAnyRightHandSide) {
  MatX A(3, 2);
  A << 1, 0, 2, 1, 0, 1;

  const NormalEquations equations(A);

  EXPECT_TRUE(is_near(equations.solve(Eigen::Vector2d(6, 0)), Eigen::Vector2d(2, -2), kTight));
  EXPECT_TRUE(is_near(equations.solve(Eigen::Vector2d(1, 1)), Eigen::Vector2d(0, 0.5), kTight));
}

}  // namespace
}  // namespace kinestat
