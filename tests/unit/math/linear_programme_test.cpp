#include "math/dense/linear_programme.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

constexpr double kClose = 1e-12;

MatX matrix(int rows, int columns, std::initializer_list<double> entries) {
  MatX result(rows, columns);
  const double* entry = entries.begin();
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      result(r, c) = *entry++;
    }
  }
  return result;
}

VecX vector(std::initializer_list<double> entries) {
  VecX result(static_cast<Eigen::Index>(entries.size()));
  Eigen::Index i = 0;
  for (const double entry : entries) {
    result[i++] = entry;
  }
  return result;
}

// Dantzig's diet in small: x + y >= 4 and x + 3 y >= 6; 2 x + 3 y is least in the corner (3, 1).
TEST(LinearProgramme, FindsTheCornerOfLeastCost) {
  const MatX A = matrix(2, 4, {1, 1, -1, 0, 1, 3, 0, -1});

  const auto x = find_least_cost(A, vector({4, 6}), vector({2, 3, 0, 0}));

  ASSERT_TRUE(x);
  EXPECT_NEAR((*x)[0], 3.0, kClose);
  EXPECT_NEAR((*x)[1], 1.0, kClose);
}

TEST(LinearProgramme, HasNoAnswerWhereTheEquationsContradict) {
  const MatX A = matrix(2, 2, {1, 1, 1, 1});

  EXPECT_FALSE(find_least_cost(A, vector({1, 2}), vector({1, 1})));
}

TEST(LinearProgramme, HasNoAnswerWhereOnlyNegativeNumbersSolve) {
  EXPECT_FALSE(find_least_cost(matrix(1, 2, {1, 2}), vector({-3}), vector({0, 0})));
}

TEST(LinearProgramme, TakesEquationsOfNegativeRightSide) {
  const auto x = find_least_cost(matrix(1, 2, {-1, 2}), vector({-3}), vector({1, 0}));

  ASSERT_TRUE(x);
  EXPECT_NEAR((*x)[0], 3.0, kClose);
  EXPECT_NEAR((*x)[1], 0.0, kClose);
}

TEST(LinearProgramme, TakesEquationsTwice) {
  const auto x = find_least_cost(matrix(2, 2, {1, 1, 2, 2}), vector({1, 2}), vector({3, 1}));

  ASSERT_TRUE(x);
  EXPECT_NEAR((*x)[1], 1.0, kClose);
}

// Beale 1955: with the rule of the steepest cost, the simplex method goes round in circles here.
TEST(LinearProgramme, DoesNotGoRoundInCircles) {
  const MatX A = matrix(
      3, 7, {0.25, -60, -0.04, 9, 1, 0, 0, 0.5, -90, -0.02, 3, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  // The costs -3/4, 150, -1/50, 6 plus 3/4 and 1/50 times what x1 and x3 at most are, as slack.
  const MatX bounded = [&] {
    MatX with(4, 8);
    with.setZero();
    with.topLeftCorner(3, 7) = A;
    with(3, 0) = 1.0;
    with(3, 7) = 1.0;  // x1 + s = 1
    return with;
  }();
  // -3/4 x1 - 1/50 x3 = 3/4 s + 1/50 x7 - 77/100.
  const auto x =
      find_least_cost(bounded, vector({0, 0, 1, 1}), vector({0, 150, 0, 6, 0, 0, 0.02, 0.75}));

  ASSERT_TRUE(x);
  EXPECT_NEAR((*x)[0], 0.04, kClose);  // Beale's optimum: x1 = 1/25, x3 = 1, at -1/20
  EXPECT_NEAR((*x)[2], 1.0, kClose);
  EXPECT_NEAR(0.75 * (*x)[7] + 0.02 * (*x)[6] + 150 * (*x)[1] + 6 * (*x)[3] - 0.77, -0.05, kClose);
}

// What rounding leaves of Beale's zeros is no step forward.
TEST(LinearProgramme, DoesNotGoRoundInCirclesByRounding) {
  const MatX A = matrix(4, 8, {0.25, -60, -0.04, 9, 1, 0, 0, 0, 0.5, -90, -0.02, 3, 0, 1, 0, 0,
                               0,    0,   1,     0, 0, 0, 1, 0, 1,   0,   0,     0, 0, 0, 0, 1});

  const auto x =
      find_least_cost(A, vector({1e-17, 1e-17, 1, 1}), vector({0, 150, 0, 6, 0, 0, 0.02, 0.75}));

  ASSERT_TRUE(x);
  EXPECT_NEAR((*x)[0], 0.04, kClose);
  EXPECT_NEAR((*x)[2], 1.0, kClose);
}

TEST(LinearProgramme, IsEmptyWithoutUnknowns) {
  EXPECT_TRUE(find_least_cost(MatX(0, 0), VecX(), VecX()));
  EXPECT_FALSE(find_least_cost(MatX(1, 0), vector({1}), VecX()));
}

}  // namespace
}  // namespace kinestat
