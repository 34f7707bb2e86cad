#include "math/elimination/equilibrate.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

SparseMatrix two_by_two(double a, double b, double c, double d) {
  SparseMatrix matrix{.rows = 2, .columns = 2, .entries = {}};
  matrix.add(0, 0, a);
  matrix.add(0, 1, b);
  matrix.add(1, 0, c);
  matrix.add(1, 1, d);
  return matrix;
}

double scaled(const SparseMatrix& matrix, const Scaling& scaling, int r, int c) {
  return matrix.dense()(r, c) * scaling.rows[static_cast<std::size_t>(r)] *
         scaling.columns[static_cast<std::size_t>(c)];
}

TEST(Scaling, UsesPowersOfTwo) {
  const Scaling scaling = find_scaling(two_by_two(3.0, 700.0, 1e-5, 0.1));

  int exponent = 0;
  EXPECT_EQ(std::frexp(scaling.rows[0], &exponent), 0.5);
  EXPECT_EQ(std::frexp(scaling.rows[1], &exponent), 0.5);
  EXPECT_EQ(std::frexp(scaling.columns[0], &exponent), 0.5);
  EXPECT_EQ(std::frexp(scaling.columns[1], &exponent), 0.5);
}

TEST(Scaling, BringsTheLargestEntryOfADiagonalToBetweenOneHalfAndOne) {
  const SparseMatrix matrix = two_by_two(3e9, 0.0, 0.0, 7e-9);

  const Scaling scaling = find_scaling(matrix);

  EXPECT_GE(scaled(matrix, scaling, 0, 0), 0.5);
  EXPECT_LT(scaled(matrix, scaling, 0, 0), 1.0);
  EXPECT_GE(scaled(matrix, scaling, 1, 1), 0.5);
  EXPECT_LT(scaled(matrix, scaling, 1, 1), 1.0);
}

TEST(Scaling, LeavesZeroRowsAndColumnsAlone) {
  const Scaling scaling = find_scaling(two_by_two(4.0, 0.0, 0.0, 0.0));

  EXPECT_EQ(scaling.rows[1], 1.0);
  EXPECT_EQ(scaling.columns[1], 1.0);
}

TEST(Scaling, DoesNotDependOnTheUnitOfARow) {
  const SparseMatrix metres = two_by_two(1.0, 2.0, 3.0, 5.0);
  const SparseMatrix other = two_by_two(1.0, 2.0, 3.0 * 1024.0, 5.0 * 1024.0);

  const Scaling a = find_scaling(metres);
  const Scaling b = find_scaling(other);

  EXPECT_EQ(scaled(metres, a, 1, 0), scaled(other, b, 1, 0));
  EXPECT_EQ(scaled(metres, a, 1, 1), scaled(other, b, 1, 1));
}

TEST(Scaling, OfAnEmptyMatrixIsEmpty) {
  const Scaling scaling = find_scaling({});

  EXPECT_TRUE(scaling.rows.empty());
  EXPECT_TRUE(scaling.columns.empty());
}

}  // namespace
}  // namespace kinestat
