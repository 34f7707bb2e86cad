#include "math/elimination/exact_input_elimination.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

ExactInputMatrix matrix_of(const std::vector<std::vector<ExactInput>>& rows) {
  ExactInputMatrix matrix{.rows = static_cast<int>(rows.size()),
                          .columns = static_cast<int>(rows.front().size()),
                          .entries = {}};
  for (int r = 0; r < matrix.rows; ++r) {
    for (int c = 0; c < matrix.columns; ++c) {
      const ExactInput& value = rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
      if (!is_zero(value)) {
        matrix.entries.push_back({.row = r, .column = c, .value = value});
      }
    }
  }
  return matrix;
}

ExactInput tenth(int count) {
  return ExactInput(count) / ExactInput(10.0);
}

// Rows that are multiples of each other as decimals and not as doubles.
TEST(ExactInputRank, OfDecimalsIsThatOfTheFractions) {
  const auto found =
      find_exact_input_rank(matrix_of({{tenth(1), tenth(3)}, {tenth(3), tenth(9)}}), 2);

  EXPECT_EQ(found->rank, 1);
  EXPECT_EQ(found->proof, ExactInputProof::elimination);
}

TEST(ExactInputRank, IsProvedByThePatternWhereItIsFull) {
  const auto found =
      find_exact_input_rank(matrix_of({{tenth(1), tenth(3)}, {tenth(3), tenth(8)}}), 2);

  EXPECT_EQ(found->rank, 2);
  EXPECT_EQ(found->proof, ExactInputProof::structural);
}

// √2 · √3 = √6.
TEST(ExactInputRank, OfRootsIsThatOfTheirField) {
  const auto found =
      find_exact_input_rank(matrix_of({{sqrt(ExactInput(2.0)), ExactInput(1.0)},
                                       {sqrt(ExactInput(6.0)), sqrt(ExactInput(3.0))}}),
                            2);

  EXPECT_EQ(found->rank, 1);
  EXPECT_EQ(found->proof, ExactInputProof::elimination);
}

// 19 and 23 are beyond the primes whose roots are exact: √19 · √23 = √437.
TEST(ExactInputRank, OfOtherNumbersIsThatOfSixtyDigits) {
  const auto found =
      find_exact_input_rank(matrix_of({{sqrt(ExactInput(19.0)), ExactInput(1.0)},
                                       {sqrt(ExactInput(437.0)), sqrt(ExactInput(23.0))}}),
                            2);

  EXPECT_EQ(found->rank, 1);
  EXPECT_EQ(found->proof, ExactInputProof::digits);
}

TEST(ExactInputRank, TellsWhatIsFarBelowADouble) {
  const ExactInput small = ExactInput(1e-25) * ExactInput(1e-25);
  const auto found =
      find_exact_input_rank(matrix_of({{sqrt(ExactInput(19.0)), ExactInput(1.0)},
                                       {sqrt(ExactInput(437.0)), sqrt(ExactInput(23.0)) + small}}),
                            2);

  EXPECT_EQ(found->rank, 2);
}

TEST(ExactInputElimination, SolvesInFractions) {
  const ExactInputElimination elimination(
      matrix_of({{ExactInput(3.0), ExactInput(1.0)}, {ExactInput(1.0), ExactInput(2.0)}}), {});

  const auto found =
      elimination.solve({}, std::vector<ExactInput>{ExactInput(1.0), ExactInput(0.0)});

  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->is_exact);
  EXPECT_EQ(found->x[0], 2.0 / 5.0);
  EXPECT_EQ(found->x[1], -1.0 / 5.0);
  EXPECT_LE(found->bound[0], 0x1p-53);
}

// (3 + 10^-20) x + y = 0 and 3 x + y = 1 have x = -10^20: as doubles they contradict each other.
TEST(ExactInputElimination, SolvesWhatRoundingMakesSingular) {
  const ExactInput near = ExactInput(3.0) + ExactInput(1.0) / ExactInput(1e10) / ExactInput(1e10);
  const ExactInputElimination elimination(
      matrix_of({{near * sqrt(ExactInput(19.0)), ExactInput(1.0)},
                 {ExactInput(3.0) * sqrt(ExactInput(19.0)), ExactInput(1.0)}}),
      {});

  const auto found =
      elimination.solve({}, std::vector<ExactInput>{ExactInput(0.0), sqrt(ExactInput(19.0))});

  ASSERT_TRUE(found.has_value());
  EXPECT_FALSE(found->is_exact);
  EXPECT_NEAR(found->x[0], -1e20, 1e5);
  EXPECT_LE(found->bound[0], 1e5);
}

// 3 x + y = 2 pi and x + 2 y = 0 have x = 4 pi / 5, y = -2 pi / 5.
TEST(ExactInputElimination, TakesAHundredDigitsWhereOnlyTheRightIsNoFraction) {
  const ExactInputElimination elimination(
      matrix_of({{ExactInput(3.0), ExactInput(1.0)}, {ExactInput(1.0), ExactInput(2.0)}}), {});

  const auto found = elimination.solve(
      {}, std::vector<ExactInput>{ExactInput(2.0) * exact_input_pi(), ExactInput(0.0)});

  ASSERT_TRUE(found.has_value());
  EXPECT_FALSE(found->is_exact);
  EXPECT_TRUE(found->consistent);
  EXPECT_NEAR(found->x[0], 0.8 * std::numbers::pi, 0x1p-51);
  EXPECT_LE(found->bound[0], 0x1p-51);
}

// 60 revolutions a minute: x = 2 pi is known, and y = x / 3.
TEST(ExactInputElimination, TakesAHundredDigitsWhereWhatIsKnownIsNoFraction) {
  const std::vector<int> last = {0};
  const ExactInputElimination elimination(matrix_of({{ExactInput(1.0), ExactInput(-3.0)}}), last);

  const auto found =
      elimination.solve(std::vector<ExactInput>{ExactInput(2.0) * exact_input_pi()}, {});

  ASSERT_TRUE(found.has_value());
  EXPECT_FALSE(found->is_exact);
  EXPECT_NEAR(found->x[1], 2.0 * std::numbers::pi / 3.0, 0x1p-51);
}

TEST(ExactInputElimination, HasNoSolutionForANumberWithoutDigits) {
  const ExactInputElimination elimination(matrix_of({{ExactInput(3.0)}}), {});

  EXPECT_FALSE(elimination.solve({}, std::vector<ExactInput>{ExactInput(1.0) / ExactInput(0.0)})
                   .has_value());
}

TEST(ExactInputElimination, SaysWhichColumnsAreFree) {
  const std::vector<int> last = {0};
  const ExactInputElimination elimination(
      matrix_of({{sqrt(ExactInput(19.0)), ExactInput(1.0), ExactInput(1.0)}}), last);

  EXPECT_EQ(elimination.free_columns().size(), 1U);
  EXPECT_EQ(elimination.relation_count(), 0);
}

TEST(ExactInputElimination, SeesContradictions) {
  const ExactInputElimination elimination(
      matrix_of({{sqrt(ExactInput(19.0))}, {sqrt(ExactInput(19.0))}}), {});

  EXPECT_TRUE(
      elimination.solve({}, std::vector<ExactInput>{ExactInput(1.0), ExactInput(1.0)})->consistent);
  EXPECT_FALSE(
      elimination.solve({}, std::vector<ExactInput>{ExactInput(1.0), ExactInput(2.0)})->consistent);
}

// x0 = √19 · √23 and x1 = x0 - √437, which is zero in all digits but the last.
TEST(ExactInputElimination, MakesADifferenceOfEqualNumbersZero) {
  const ExactInput one(1.0);
  const ExactInputElimination elimination(
      matrix_of({{one, ExactInput(0.0), -sqrt(ExactInput(19.0)), ExactInput(0.0)},
                 {-one, one, ExactInput(0.0), one}}),
      std::vector<int>{2, 3});

  const auto solved = elimination.solve(
      std::vector<ExactInput>{sqrt(ExactInput(23.0)), sqrt(ExactInput(437.0))}, {});

  ASSERT_TRUE(solved.has_value());
  EXPECT_EQ(solved->x[1], 0.0);
  EXPECT_LT(solved->bound[1], 1e-58);
  EXPECT_NEAR(solved->x[0], std::sqrt(437.0), 1e-14);
}

}  // namespace
}  // namespace kinestat
