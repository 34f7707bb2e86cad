#include "math/elimination/bounded_solve.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "math/elimination/exact_elimination.hpp"

namespace kinestat {
namespace {

// A Hilbert matrix of fractions 1/(i + j + 1), rounded: its condition grows by 33 an unknown.
SparseMatrix hilbert(int size) {
  SparseMatrix matrix{.rows = size, .columns = size, .entries = {}};
  for (int r = 0; r < size; ++r) {
    for (int c = 0; c < size; ++c) {
      matrix.add(r, c, 1.0 / (r + c + 1.0));
    }
  }
  return matrix;
}

class HilbertSystem : public ::testing::Test {
 protected:
  BoundedSolution solve(Accuracy accuracy, int digits = kUsualDigits) const {
    return solve_to_digits(
        elimination_, {}, rhs_, {.accuracy = accuracy, .digits = digits}, counts_);
  }

  // Against the solution of these very doubles in fractions.
  void expect_covered(const BoundedSolution& found) const {
    const std::vector<Rational> right(rhs_.begin(), rhs_.end());
    const ExactSolution exact = ExactElimination(exact_matrix(hilbert(kSize)), {}).solve({}, right);
    ASSERT_TRUE(found.bound.has_value());
    for (int i = 0; i < kSize; ++i) {
      const Rational error = exact.x[static_cast<std::size_t>(i)] - Rational(found.solution.x[i]);
      EXPECT_LE(abs(error), Rational((*found.bound)[i])) << "unknown " << i;
    }
  }

  static constexpr int kSize = 6;
  Elimination elimination_{hilbert(kSize), {}};
  std::vector<double> rhs_ = std::vector<double>(kSize, 1.0);
  std::vector<bool> counts_ = std::vector<bool>(kSize, true);
};

TEST_F(HilbertSystem, HasNoBoundWhereNoneIsAskedFor) {
  const BoundedSolution found = solve(Accuracy::fast);

  EXPECT_EQ(found.precision, Precision::plain);
  EXPECT_FALSE(found.bound.has_value());
}

TEST_F(HilbertSystem, StaysInDoubleWhileTheBoundPromisesTheDigits) {
  const BoundedSolution found = solve(Accuracy::automatic, 6);

  EXPECT_EQ(found.precision, Precision::plain);
  expect_covered(found);
}

TEST_F(HilbertSystem, IsRefinedWhereTheBoundDoesNotPromiseTheDigits) {
  const BoundedSolution found = solve(Accuracy::automatic, 14);

  EXPECT_EQ(found.precision, Precision::refined);
  EXPECT_LE(worst_relative_error(found.solution.x, *found.bound, counts_, 0.0), 1e-14);
  expect_covered(found);
}

TEST_F(HilbertSystem, HasAllDigitsOfADoubleWithHighAccuracy) {
  const BoundedSolution found = solve(Accuracy::high);

  EXPECT_EQ(found.precision, Precision::refined);
  EXPECT_LE(worst_relative_error(found.solution.x, *found.bound, counts_, 0.0), 0x1p-52);
  expect_covered(found);
}

TEST(WorstRelativeError, IsThatOfTheValuesThatCount) {
  const VecX values = Eigen::Vector3d(2.0, 1.0, 4.0);
  const VecX bounds = Eigen::Vector3d(0.5, 0.75, 0.5);

  EXPECT_EQ(worst_relative_error(values, bounds, {true, false, true}, 0.0), 0.25);
}

TEST(WorstRelativeError, IsOneWhereABoundThatIsNoRoundingExceedsItsValue) {
  const VecX values = Eigen::Vector2d(1.0, 1e-12);
  const VecX bounds = Eigen::Vector2d(0.0, 1e-11);

  EXPECT_EQ(worst_relative_error(values, bounds, {true, true}, 0.0), 1.0);
}

TEST(WorstRelativeError, LeavesOutWhatIsZeroButForRoundingOfTheLargest) {
  const VecX values = Eigen::Vector2d(1.0, 1e-17);
  const VecX bounds = Eigen::Vector2d(0.0, 1e-16);

  EXPECT_EQ(worst_relative_error(values, bounds, {true, true}, 0.0), 0.0);
}

TEST(WorstRelativeError, LeavesOutWhatIsZeroButForRoundingOfTheRightHandSide) {
  const VecX values = Eigen::VectorXd::Constant(1, 1e-17);
  const VecX bounds = Eigen::VectorXd::Constant(1, 1e-16);

  EXPECT_EQ(worst_relative_error(values, bounds, {true}, 1.0), 0.0);
  EXPECT_EQ(worst_relative_error(values, bounds, {true}, 1e-15), 1.0);
}

TEST_F(HilbertSystem, IsSolvedExactlyWhereNothingIsKnown) {
  rhs_.assign(kSize, 0.0);

  const BoundedSolution found = solve(Accuracy::automatic);

  EXPECT_EQ(found.precision, Precision::plain);
  ASSERT_TRUE(found.bound.has_value());
  EXPECT_TRUE(found.bound->isZero(0.0));
}

}  // namespace
}  // namespace kinestat
