#include "math/dense/least_squares.hpp"

#include <cmath>

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "support/near.hpp"
#include "support/random.hpp"

namespace kinestat {
namespace {

using Flags = std::vector<bool>;

TEST(LeastSquares, OfOneUnknownAreTheDistancesFromTheMean) {
  const LeastSquares found =
      find_least_squares(MatX::Ones(3, 1), Vec3(1.0, 2.0, 6.0), Vec3(1.0, 1.0, 1.0));

  EXPECT_TRUE(is_near(found.values, Vec3(-2.0, -1.0, 3.0), kTight));
  EXPECT_EQ(found.is_open, (Flags{false, false, false}));
  EXPECT_EQ(found.evidence.rank, 1);
}

TEST(LeastSquares, WithWeightsAreTheDistancesFromTheWeightedMean) {
  // Of 1, 2 and 6 with w² = 1, 1, 2 the mean is 15/4.
  const LeastSquares found =
      find_least_squares(MatX::Ones(3, 1), Vec3(1.0, 2.0, 6.0), Vec3(1.0, 1.0, std::sqrt(2.0)));

  EXPECT_TRUE(is_near(found.values, Vec3(-11.0 / 4.0, -7.0 / 4.0, 9.0 / 4.0), kTight));
}

TEST(LeastSquares, LetValuesWithoutWeightFollow) {
  // The second value has the weight, becomes zero and takes the first along.
  MatX A(2, 1);
  A << 2, 1;

  const LeastSquares found =
      find_least_squares(A, Eigen::Vector2d(5.0, 3.0), Eigen::Vector2d(0.0, 1.0));

  EXPECT_TRUE(is_near(found.values, Eigen::Vector2d(-1.0, 0.0), kTight));
  EXPECT_EQ(found.is_open, (Flags{false, false}));
}

TEST(LeastSquares, LeaveOpenWhatNoWeightHolds) {
  // The second column moves only the last two values, which have no weight.
  MatX A(4, 2);
  A << 1, 0, 1, 0, 0, 1, 1, 1;

  const LeastSquares found =
      find_least_squares(A, Eigen::Vector4d(1.0, 3.0, 0.0, 0.0), Eigen::Vector4d(1, 1, 0, 0));

  EXPECT_NEAR(found.values[0], -1.0, kTight);
  EXPECT_NEAR(found.values[1], 1.0, kTight);
  EXPECT_EQ(found.is_open, (Flags{false, false, true, true}));
}

TEST(LeastSquares, SplitTheirColumnsByWhatTheWeightsSee) {
  // The sum of both columns is seen as well, so the second is not by itself open: their difference
  // is.
  MatX A(3, 2);
  A << 2, 2, 1, 0, 0, 1;

  const LeastSquares found = find_least_squares(A, Vec3::Zero(), Vec3(4.0, 0.0, 0.0));

  ASSERT_EQ(found.measured.cols(), 1);
  ASSERT_EQ(found.open.cols(), 1);
  EXPECT_NEAR(std::abs(4.0 * found.measured(0, 0)), 1.0, kTight);
  EXPECT_EQ(found.open(0, 0), 0.0);
  EXPECT_NEAR(found.open(1, 0), -found.open(2, 0), kTight);
  EXPECT_NE(found.open(1, 0), 0.0);
}

TEST(LeastSquares, WithoutUnknownsAreTheConstants) {
  const LeastSquares found = find_least_squares(MatX(2, 0), Eigen::Vector2d(1, 2), VecX::Ones(2));

  EXPECT_TRUE(is_near(found.values, Eigen::Vector2d(1.0, 2.0), 0.0));
  EXPECT_EQ(found.is_open, (Flags{false, false}));
}

TEST(LeastSquares, AreAsExactForWeightsOfVeryDifferentSize) {
  // Values x + y - 4, x - y - 2, x - 7: the heavy first two vanish, for x = 3 and y = 1.
  MatX A(3, 2);
  A << 1, 1, 1, -1, 1, 0;

  const LeastSquares found = find_least_squares(A, Vec3(-4.0, -2.0, -7.0), Vec3(1e8, 1e4, 1e-12));

  EXPECT_TRUE(is_near(found.values, Vec3(0.0, 0.0, -4.0), 1e-14));
}

TEST(LeastSquares, KeepTheSmallShareOfAHeavyValue) {
  // 1 N shared by springs of compliance c and 1: v = x and 1 - x, the least c x² + (1 - x)².
  MatX A(2, 1);
  A << 1, -1;
  const double c = 1e20;

  const LeastSquares found =
      find_least_squares(A, Eigen::Vector2d(0.0, 1.0), Eigen::Vector2d(std::sqrt(c), 1.0));

  EXPECT_NEAR(found.values[0] * (1.0 + c), 1.0, 1e-14);
  EXPECT_EQ(found.values[1], 1.0);
}

class RandomLeastSquares : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Seed, RandomLeastSquares, ::testing::Range(0, 60));

// The second way: the pseudo-inverse by singular values. Columns 5 and 6 follow from the others.
TEST_P(RandomLeastSquares, AreThoseOfThePseudoInverse) {
  Random random(static_cast<std::uint64_t>(GetParam()));
  MatX A = MatX::NullaryExpr(12, 7, [&] { return random.between(-1.0, 1.0); });
  A.col(5) = A.col(0) + 2.0 * A.col(1);
  A.col(6) = A.col(2) - A.col(3);
  const VecX b = VecX::NullaryExpr(12, [&] { return random.between(-1.0, 1.0); });
  const VecX w = VecX::NullaryExpr(12, [&] { return std::pow(10.0, random.between(-1.0, 1.0)); });

  const LeastSquares found = find_least_squares(A, b, w);

  const MatX weighted = w.asDiagonal() * A;
  Eigen::JacobiSVD<MatX> svd(weighted, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(1e-10);
  const VecX x = svd.solve(-w.cwiseProduct(b));
  EXPECT_EQ(found.evidence.rank, 5);
  EXPECT_TRUE(is_near(found.values, A * x + b, 1e-10));
  EXPECT_EQ(found.is_open, Flags(12, false));
}

}  // namespace
}  // namespace kinestat
