#include "math/dense/smallest_singular_value.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(SingularValueShare, IsThatOfTheLargest) {
  MatX matrix = MatX::Zero(4, 3);
  matrix.diagonal() << 2.0, 8.0, -4.0;

  EXPECT_DOUBLE_EQ(singular_value_share(matrix, 1), 1.0);
  EXPECT_DOUBLE_EQ(singular_value_share(matrix, 2), 0.5);
  EXPECT_DOUBLE_EQ(singular_value_share(matrix, 3), 0.25);
  EXPECT_DOUBLE_EQ(singular_value_share(matrix.transpose(), 3), 0.25);
}

TEST(SingularValueShare, IsZeroBeyondTheLastAndOfNothing) {
  EXPECT_EQ(singular_value_share(MatX::Identity(2, 3), 3), 0.0);
  EXPECT_EQ(singular_value_share(MatX::Zero(2, 2), 1), 0.0);
  EXPECT_EQ(singular_value_share(MatX(0, 3), 1), 0.0);
}

}  // namespace
}  // namespace kinestat
