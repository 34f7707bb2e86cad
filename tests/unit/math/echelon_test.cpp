#include "math/elimination/echelon.hpp"

#include <gtest/gtest.h>

#include "support/near.hpp"

namespace kinestat {
namespace {

TEST(Echelon, OfARegularMatrixIsTheIdentity) {
  MatX matrix(2, 2);
  matrix << 2.0, 1.0, 1.0, 3.0;

  const Echelon echelon = find_echelon(matrix);

  EXPECT_TRUE(is_near(echelon.matrix, MatX::Identity(2, 2), kTight));
  EXPECT_EQ(echelon.pivot_columns, (std::vector<int>{0, 1}));
}

TEST(Echelon, KeepsRedundantRowsAsZerosAtTheBottom) {
  MatX matrix(3, 3);
  matrix << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0;
  MatX expected(3, 3);
  expected << 1.0, 0.0, -1.0, 0.0, 1.0, 2.0, 0.0, 0.0, 0.0;

  const Echelon echelon = find_echelon(matrix);

  EXPECT_TRUE(is_near(echelon.matrix, expected, kTight));
  EXPECT_EQ(echelon.pivot_columns, (std::vector<int>{0, 1}));
}

TEST(Echelon, PassesOverAColumnWithoutPivot) {
  MatX matrix(2, 3);
  matrix << 0.0, 2.0, 4.0, 0.0, 1.0, 3.0;
  MatX expected(2, 3);
  expected << 0.0, 1.0, 0.0, 0.0, 0.0, 1.0;

  const Echelon echelon = find_echelon(matrix);

  EXPECT_TRUE(is_near(echelon.matrix, expected, kTight));
  EXPECT_EQ(echelon.pivot_columns, (std::vector<int>{1, 2}));
}

// Where the source's elimination divides by the first entry, it would divide by zero.
TEST(Echelon, ExchangesRowsWhereThePivotIsZero) {
  MatX matrix(2, 2);
  matrix << 0.0, 1.0, 1.0, 0.0;

  EXPECT_TRUE(is_near(find_echelon(matrix).matrix, MatX::Identity(2, 2), kTight));
}

TEST(Echelon, OfAMatrixWithoutRowsHasNoPivots) {
  EXPECT_TRUE(find_echelon(MatX(0, 3)).pivot_columns.empty());
}

}  // namespace
}  // namespace kinestat
