#include "math/elimination/rank.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(Rank, OfAnEmptyMatrixIsZero) {
  EXPECT_EQ(find_rank(MatX(0, 3)).rank, 0);
}

TEST(Rank, OfAZeroMatrixIsZero) {
  EXPECT_EQ(find_rank(MatX::Zero(2, 3)).rank, 0);
}

TEST(Rank, OfAnOuterProductIsOne) {
  const VecX a = (VecX(3) << 1.0, 2.0, 3.0).finished();
  const VecX b = (VecX(4) << 4.0, 5.0, 6.0, 7.0).finished();

  EXPECT_EQ(find_rank(a * b.transpose()).rank, 1);
}

// The Hilbert matrix of order 4 is flat (condition 1.6e4) but regular: its determinant is
// 1/6048000.
TEST(Rank, OfAFlatMatrixIsFull) {
  MatX hilbert(4, 4);
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) {
      hilbert(r, c) = 1.0 / (r + c + 1);
    }
  }

  EXPECT_EQ(find_rank(hilbert).rank, 4);
}

TEST(Rank, DoesNotDependOnUnits) {
  MatX matrix(2, 2);
  matrix << 1e-9, 2e3, 0.0, 1e9;

  EXPECT_EQ(find_rank(matrix).rank, 2);
}

TEST(Rank, HasAnInfiniteGapWhereNothingWasDropped) {
  EXPECT_TRUE(std::isinf(find_rank(MatX::Identity(3, 3)).gap()));
}

TEST(RankEvidence, HasAGapOfTheDecadesBetweenWhatCountedAndWhatDidNot) {
  const RankEvidence evidence{
      .rank = 1, .smallest_pivot = 1e-2, .largest_dropped = 1e-14, .method = ""};

  EXPECT_NEAR(evidence.gap(), 12.0, 1e-9);
}

}  // namespace
}  // namespace kinestat
