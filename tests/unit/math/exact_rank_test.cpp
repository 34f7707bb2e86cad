#include "math/elimination/exact_rank.hpp"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "support/random_fractions.hpp"

namespace kinestat {
namespace {

// cos 2π(i - k)/n, i and k of 0, …, n - 1: the sum of two products of a column with a row, cos cos
// + sin sin, of rank 2; and of rank 1 if all sines are zero.
RootMatrix cosines_of_differences(int n, int root_count) {
  RootMatrix matrix{.rows = n, .columns = n, .root_count = root_count, .entries = {}};
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      matrix.entries.push_back({.row = i,
                                .column = k,
                                .value = RootSum::cosine((i - k) * (root_count / n), root_count)});
    }
  }
  return matrix;
}

int order_of(const ExactMatrix& matrix) {
  return std::min(matrix.rows, matrix.columns);
}

TEST(ExactRank, OfNoEntriesIsZeroAndProvedByThePattern) {
  const ExactRank rank = find_exact_rank(ExactMatrix{.rows = 3, .columns = 2, .entries = {}}, 0);

  EXPECT_EQ(rank.rank, 0);
  EXPECT_EQ(rank.proof, RankProof::structural);
}

TEST(ExactRank, ReachesThePatternWithoutElimination) {
  const ExactMatrix matrix{
      .rows = 2, .columns = 2, .entries = {{0, 0, Rational(1, 3)}, {1, 1, Rational(1)}}};

  const ExactRank rank = find_exact_rank(matrix, 2);

  EXPECT_EQ(rank.rank, 2);
  EXPECT_EQ(rank.proof, RankProof::structural);
}

// A matrix whose determinant the first prime divides: alone it would say 1.
TEST(ExactRank, IsNotMisledByItsPrime) {
  const PrimeField field(1, 20261121);
  const Rational prime{Integer(field.modulus())};
  const ExactMatrix matrix{
      .rows = 3, .columns = 3, .entries = {{0, 0, Rational(1)}, {1, 1, prime}}};

  const ExactRank rank = find_exact_rank(matrix, 3);

  EXPECT_EQ(rank.rank, 2);
  EXPECT_EQ(rank.proof, RankProof::elimination);
  EXPECT_EQ(find_exact_rank(matrix, 2).rank, 2);
}

TEST(ExactRank, IsFoundWhereThePrimeDividesADenominator) {
  const PrimeField field(1, 20261121);
  const Rational inverse(Integer(1), Integer(field.modulus()));

  EXPECT_EQ(
      find_exact_rank(ExactMatrix{.rows = 1, .columns = 1, .entries = {{0, 0, inverse}}}, 1).rank,
      1);
}

// The third column is the sum of the others.
TEST(ExactRank, OfSmallNumbersIsProvedByNullVectors) {
  SparseMatrix matrix{.rows = 4, .columns = 3, .entries = {}};
  matrix.entries = {{0, 0, 1.0},
                    {0, 1, 0.5},
                    {0, 2, 1.5},
                    {1, 0, 3.0},
                    {1, 2, 3.0},
                    {2, 1, -7.0},
                    {2, 2, -7.0},
                    {3, 0, 0.125},
                    {3, 1, 2.0},
                    {3, 2, 2.125}};

  const ExactRank rank = find_exact_rank(matrix, 3);

  EXPECT_EQ(rank.rank, 2);
  EXPECT_EQ(rank.proof, RankProof::null_vectors);
  EXPECT_EQ(rank.error_probability, 0.0);
}

TEST(ExactRank, OfAWideMatrixIsThatOfATallOne) {
  SparseMatrix matrix{.rows = 2, .columns = 5, .entries = {}};
  for (int c = 0; c < 5; ++c) {
    matrix.add(0, c, c + 1.0);
    matrix.add(1, c, -3.0 * (c + 1.0));
  }

  const ExactRank rank = find_exact_rank(matrix, 2);

  EXPECT_EQ(rank.rank, 1);
  EXPECT_EQ(rank.proof, RankProof::null_vectors);
}

// 0.1, 0.3 and 0.9 as doubles: their null vector has no small fractions.
TEST(ExactRank, OfRoundedDecimalsIsProvedByElimination) {
  SparseMatrix matrix{.rows = 3, .columns = 2, .entries = {}};
  for (int r = 0; r < 3; ++r) {
    matrix.add(r, 0, 0.1 * (r + 1.0));
    matrix.add(r, 1, 0.3);
  }
  matrix.entries[2].value = 2.0 * matrix.entries[0].value;
  matrix.entries[4].value = 4.0 * matrix.entries[0].value;
  matrix.entries[3].value = 2.0 * matrix.entries[1].value;
  matrix.entries[5].value = 4.0 * matrix.entries[1].value;

  const ExactRank rank = find_exact_rank(matrix, 2);

  EXPECT_EQ(rank.rank, 1);
  EXPECT_EQ(rank.proof, RankProof::elimination);
}

// The determinant is the prime, and so zero modulo it: 2^28 and 1 are a null vector there, of small
// numbers.
TEST(ExactRank, OfDoublesIsNotMisledByItsPrime) {
  constexpr std::uint64_t kPower = std::uint64_t{1} << 28U;
  const std::uint64_t prime = PrimeField(1, 20261121).modulus();
  SparseMatrix matrix{.rows = 2, .columns = 2, .entries = {}};
  matrix.add(0, 0, static_cast<double>(kPower));
  matrix.add(0, 1, 1.0);
  matrix.add(1, 0, -static_cast<double>(prime % kPower));
  matrix.add(1, 1, static_cast<double>(prime / kPower));

  EXPECT_EQ(find_exact_rank(matrix, 2).rank, 2);
}

class ExactRanks : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Seed, ExactRanks, ::testing::Range(0, 25));

// Whole numbers from -9 to 9: of such a matrix null vectors are small while the rank is.
TEST_P(ExactRanks, OfWholeNumbersAreThoseTheMatrixWasBuiltWith) {
  Random random(static_cast<std::uint64_t>(GetParam()));
  const int built = random.whole(0, 4);
  const int rows = built + random.whole(0, 9);
  const int columns = built + random.whole(0, 9);
  MatX left(rows, built);
  MatX right(built, columns);
  for (MatX* part : {&left, &right}) {
    for (double& value : part->reshaped()) {
      value = random.whole(-9, 9);
    }
  }
  // A triangle of ones makes sure of the rank.
  for (int i = 0; i < built; ++i) {
    left.row(i).setZero();
    left(i, i) = 1.0;
    right.col(i).setZero();
    right(i, i) = 1.0;
  }
  const MatX product = left * right;
  SparseMatrix matrix{.rows = rows, .columns = columns, .entries = {}};
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      matrix.add(r, c, product(r, c));
    }
  }

  EXPECT_EQ(find_exact_rank(matrix, std::min(rows, columns)).rank, built);
}

TEST_P(ExactRanks, AreThoseTheMatrixWasBuiltWith) {
  Random random(static_cast<std::uint64_t>(GetParam()));
  const int built = random.whole(0, 20);
  const ExactMatrix matrix =
      random_matrix(built + random.whole(0, 5), built + random.whole(0, 5), built, random);

  const ExactRank rank = find_exact_rank(matrix, order_of(matrix));

  EXPECT_EQ(rank.rank, built);
  EXPECT_EQ(rank.proof, built == order_of(matrix) ? RankProof::structural : RankProof::elimination);
  EXPECT_EQ(rank.error_probability, 0.0);
}

class Planets : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Count, Planets, ::testing::Range(1, 13));

TEST_P(Planets, HaveDirectionsOfProvedRankTwo) {
  const int n = GetParam();

  const ExactRank rank = find_exact_rank(cosines_of_differences(n, std::lcm(4, n)), n);

  EXPECT_EQ(rank.rank, n <= 2 ? 1 : 2);
  EXPECT_EQ(rank.proof, n == 1 ? RankProof::structural : RankProof::elimination);
}

// What rounding does to them: five planets as doubles, and as such exact, have another rank.
TEST(ExactRank, OfRoundedDirectionsIsAnother) {
  const RootMatrix exact = cosines_of_differences(5, 20);
  SparseMatrix rounded{.rows = 5, .columns = 5, .entries = {}};
  for (const RootEntry& entry : exact.entries) {
    rounded.add(entry.row, entry.column, entry.value.value().real());
  }

  EXPECT_EQ(find_exact_rank(exact, 5).rank, 2);
  EXPECT_GT(find_exact_rank(exact_matrix(rounded), 5).rank, 2);
}

// With whole degrees a number has 96 parts, and only the primes are asked.
TEST(ExactRank, OfWholeDegreesIsModularWithItsErrorProbability) {
  const ExactRank rank = find_exact_rank(cosines_of_differences(30, 360), 30);

  EXPECT_EQ(rank.rank, 2);
  EXPECT_EQ(rank.proof, RankProof::modular);
  EXPECT_GT(rank.error_probability, 0.0);
  EXPECT_LT(rank.error_probability, 1e-20);
}

TEST(ExactRank, OfWholeDegreesIsProvedWhereThePatternAllowsNoMore) {
  RootMatrix matrix = cosines_of_differences(30, 360);
  std::erase_if(matrix.entries, [](const RootEntry& entry) { return entry.row > 1; });

  const ExactRank rank = find_exact_rank(matrix, 2);

  EXPECT_EQ(rank.rank, 2);
  EXPECT_EQ(rank.proof, RankProof::structural);
  EXPECT_EQ(rank.error_probability, 0.0);
}

// 300 rows that depend on 299 others, all full: 9 million products of growing fractions would take
// minutes.
TEST(ExactRank, OfALargeFullMatrixIsModular) {
  constexpr int kSize = 300;
  Random random(1);
  ExactMatrix matrix{.rows = kSize, .columns = kSize, .entries = {}};
  for (int c = 0; c < kSize; ++c) {
    Rational sum = 0;
    for (int r = 0; r + 1 < kSize; ++r) {
      matrix.entries.push_back({.row = r, .column = c, .value = random_fraction(random)});
      sum += matrix.entries.back().value;
    }
    matrix.entries.push_back({.row = kSize - 1, .column = c, .value = sum});
  }

  const ExactRank rank = find_exact_rank(matrix, kSize);

  EXPECT_EQ(rank.rank, kSize - 1);
  EXPECT_EQ(rank.proof, RankProof::modular);
  EXPECT_LT(rank.error_probability, 1e-20);
}

TEST(RankProof, HasAnotherTextForEachKind) {
  EXPECT_EQ(text_of(RankProof::structural), "structural bound");
  EXPECT_EQ(text_of(RankProof::elimination), "exact elimination");
  EXPECT_EQ(text_of(RankProof::null_vectors), "exact null vectors");
  EXPECT_EQ(text_of(RankProof::modular), "modulo two primes");
}

}  // namespace
}  // namespace kinestat
