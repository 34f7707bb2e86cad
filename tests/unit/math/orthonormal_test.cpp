#include <gtest/gtest.h>

#include "math/dense/span.hpp"
#include "support/near.hpp"
#include "support/random.hpp"

namespace kinestat {
namespace {

// 6 x 5 of rank 3.
MatX rank_three() {
  Random random(1);
  MatX left(6, 3);
  MatX right(3, 5);
  for (Eigen::Index i = 0; i < left.size(); ++i) {
    left.data()[i] = random.magnitude();
  }
  for (Eigen::Index i = 0; i < right.size(); ++i) {
    right.data()[i] = random.magnitude();
  }
  return left * right;
}

TEST(OrthonormalRange, HasAsManyColumnsAsTheRank) {
  EXPECT_EQ(orthonormal_range(rank_three()).cols(), 3);
}

TEST(OrthonormalRange, HasOrthonormalColumns) {
  const MatX basis = orthonormal_range(rank_three());

  EXPECT_TRUE(is_near(basis.transpose() * basis, MatX::Identity(3, 3), kTight));
}

TEST(OrthonormalRange, HoldsEveryColumn) {
  const MatX matrix = rank_three();
  const MatX basis = orthonormal_range(matrix);

  EXPECT_TRUE(is_near(basis * (basis.transpose() * matrix), matrix, 10 * kTight));
}

TEST(OrthonormalRange, OfZeroColumnsIsEmpty) {
  EXPECT_EQ(orthonormal_range(MatX::Zero(6, 2)).cols(), 0);
}

TEST(OrthonormalRange, OfNoColumnsIsEmpty) {
  EXPECT_EQ(orthonormal_range(MatX(6, 0)).cols(), 0);
}

// The second row has its largest entry where it is three times the first: beside that only 1 is
// left.
TEST(DecidingColumns, AreWhereRowsDifferFromThoseBefore) {
  MatX rows(3, 3);
  rows << 2.0, 1.0, 0.0,  //
      6.0, 3.0, 1.0,      //
      8.0, 4.0, 1.0;

  EXPECT_EQ(deciding_columns(rows), (std::vector<int>{0, 2}));
}

TEST(DecidingColumns, AreNoneOfZeros) {
  EXPECT_TRUE(deciding_columns(MatX::Zero(2, 3)).empty());
  EXPECT_TRUE(deciding_columns(MatX(0, 3)).empty());
}

}  // namespace
}  // namespace kinestat
