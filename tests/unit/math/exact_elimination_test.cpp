#include "math/elimination/exact_elimination.hpp"

#include <gtest/gtest.h>

#include "support/random_fractions.hpp"

namespace kinestat {
namespace {

Fractions product(const ExactMatrix& A, const Fractions& x) {
  Fractions result(static_cast<std::size_t>(A.rows));
  for (const ExactEntry& entry : A.entries) {
    result[static_cast<std::size_t>(entry.row)] +=
        entry.value * x[static_cast<std::size_t>(entry.column)];
  }
  return result;
}

Fractions random_fractions(int count, Random& random) {
  Fractions result;
  for (int i = 0; i < count; ++i) {
    result.push_back(random_fraction(random));
  }
  return result;
}

TEST(ExactElimination, OfNoEquationsLeavesAllFree) {
  const ExactElimination elimination(ExactMatrix{.rows = 0, .columns = 2, .entries = {}}, {});

  EXPECT_EQ(elimination.rank(), 0);
  EXPECT_EQ(elimination.free_columns(), (std::vector<int>{0, 1}));
}

TEST(ExactElimination, AddsEntriesAtTheSamePlace) {
  const ExactMatrix matrix{.rows = 1,
                           .columns = 2,
                           .entries = {{0, 1, Rational(1, 3)},
                                       {0, 0, Rational(1)},
                                       {0, 1, Rational(2, 3)},
                                       {0, 0, Rational(-1)}}};

  const ExactElimination elimination(matrix, {});

  EXPECT_EQ(elimination.free_columns(), std::vector<int>{0});
  EXPECT_EQ(elimination.solve({}, Fractions{5}).x, (Fractions{0, 5}));
}

// Regular for every size, and so flat that doubles see rank 10 at most. The first column of its
// inverse begins with n², and entry i + 1 is entry i times -(n + i + 1)(n - i - 1) / (i + 1)(i + 2)
// (from the binomials of Choi, Am. Math. Monthly 90, 1983).
TEST(ExactElimination, SolvesTheHilbertMatrixOfOrderTwenty) {
  const int n = 20;
  std::vector<Fractions> hilbert;
  Fractions first_of_inverse;
  Rational entry = n * n;
  for (int i = 0; i < n; ++i) {
    hilbert.emplace_back();
    for (int j = 0; j < n; ++j) {
      hilbert.back().emplace_back(1, i + j + 1);
    }
    first_of_inverse.push_back(entry);
    entry *= Rational(-(n + i + 1) * (n - i - 1), (i + 1) * (i + 2));
  }
  Fractions unit(n);
  unit.front() = 1;

  const ExactElimination elimination(matrix_of(hilbert), {});

  EXPECT_EQ(elimination.rank(), n);
  EXPECT_EQ(elimination.solve({}, unit).x, first_of_inverse);
}

TEST(ExactElimination, TellsADifferenceOfOneInADoublesLastPlace) {
  SparseMatrix matrix{.rows = 2, .columns = 2, .entries = {}};
  matrix.add(0, 0, 1.0);
  matrix.add(0, 1, 1.0);
  matrix.add(1, 0, 1.0);
  matrix.add(1, 1, 1.0 + 0x1p-52);

  EXPECT_EQ(ExactElimination(exact_matrix(matrix), {}).rank(), 2);
}

// 0.1 + 0.2 - 0.3 is zero as typed and 2^-55 as doubles: the exact rank of doubles is not that of
// the drawing.
TEST(ExactElimination, TakesDoublesAtTheirWord) {
  SparseMatrix matrix{.rows = 1, .columns = 1, .entries = {}};
  matrix.add(0, 0, 0.1);
  matrix.add(0, 0, 0.2);
  matrix.add(0, 0, -0.3);

  EXPECT_EQ(ExactElimination(exact_matrix(matrix), {}).rank(), 1);
}

TEST(ExactElimination, SolvesForTheColumnsThatAreNotKnown) {
  // x_0 + 2 x_1 - x_2 = 7, x_0 - x_1 = 1 with x_2 = 3.
  const ExactElimination elimination(matrix_of({{1, 2, -1}, {1, -1, 0}}), std::vector<int>{2});

  const ExactSolution solution = elimination.solve(Fractions{3}, Fractions{7, 1});

  EXPECT_TRUE(solution.consistent);
  EXPECT_EQ(solution.x, (Fractions{4, 3, 3}));
}

TEST(ExactElimination, CountsTheRelationsBetweenKnownColumns) {
  // x_0 = x_2 = x_1.
  const ExactElimination elimination(matrix_of({{1, 0, -1}, {0, 1, -1}}), std::vector<int>{0, 1});

  EXPECT_EQ(elimination.relation_count(), 1);
  EXPECT_FALSE(elimination.solve(Fractions{1, 2}, {}).consistent);
  EXPECT_TRUE(elimination.solve(Fractions{2, 2}, {}).consistent);
}

TEST(ExactElimination, SaysThatSurplusEquationsContradictBeyondTheDigitsOfADouble) {
  const ExactElimination elimination(matrix_of({{1, 1}, {1, -1}, {3, 1}}), {});
  const Rational little = *read_decimal("1e-40");

  EXPECT_TRUE(elimination.solve({}, Fractions{3, 1, 7}).consistent);
  EXPECT_FALSE(elimination.solve({}, Fractions{3, 1, 7 + little}).consistent);
}

class ExactSystems : public ::testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam())};
};

INSTANTIATE_TEST_SUITE_P(Seed, ExactSystems, ::testing::Range(0, 25));

TEST_P(ExactSystems, HaveTheRankTheyWereBuiltWith) {
  const int rank = random_.whole(0, 20);
  const ExactMatrix matrix =
      random_matrix(rank + random_.whole(1, 10), rank + random_.whole(1, 10), rank, random_);

  const ExactElimination elimination(matrix, {});

  EXPECT_EQ(elimination.rank(), rank);
}

TEST_P(ExactSystems, HaveIndependentNullVectorsThatTheMatrixAnnuls) {
  const int rank = random_.whole(1, 15);
  const ExactMatrix matrix = random_matrix(rank + 3, rank + 5, rank, random_);

  const ExactElimination elimination(matrix, {});
  const std::vector<Fractions> vectors = elimination.null_vectors();

  ASSERT_EQ(vectors.size(), 5U);
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    EXPECT_EQ(product(matrix, vectors[i]), Fractions(static_cast<std::size_t>(matrix.rows)));
    for (std::size_t j = 0; j < vectors.size(); ++j) {
      EXPECT_EQ(vectors[i][static_cast<std::size_t>(elimination.free_columns()[j])], i == j);
    }
  }
}

TEST_P(ExactSystems, AreSolvedWithoutRemainder) {
  const int rank = random_.whole(5, 20);
  const ExactMatrix matrix = random_matrix(rank + 4, rank + 6, rank, random_);
  const Fractions x = random_fractions(matrix.columns, random_);
  const Fractions right = product(matrix, x);
  const std::vector<int> last = {3, 1, 4};
  const Fractions known = {x[3], x[1], x[4]};

  const ExactSolution solution = ExactElimination(matrix, last).solve(known, right);

  EXPECT_TRUE(solution.consistent);
  EXPECT_EQ(product(matrix, solution.x), right);
  EXPECT_EQ((Fractions{solution.x[3], solution.x[1], solution.x[4]}), known);
}

}  // namespace
}  // namespace kinestat
