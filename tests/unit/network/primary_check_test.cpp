#include "network/primary_check.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "core/rounding.hpp"

namespace kinestat {
namespace {

// x_0 = x_1, x_2 = x_3, …: one free magnitude a pair.
SparseMatrix equal_pairs(int pair_count) {
  SparseMatrix matrix{.rows = pair_count, .columns = 2 * pair_count, .entries = {}};
  for (int i = 0; i < pair_count; ++i) {
    matrix.add(i, 2 * i, 1.0);
    matrix.add(i, 2 * i + 1, -1.0);
  }
  return matrix;
}

// x_0 + x_1 = 0, x_1 + x_2 = 0 and x_3 alone.
SparseMatrix chain_and_free() {
  SparseMatrix matrix{.rows = 2, .columns = 4, .entries = {}};
  matrix.add(0, 0, 1.0);
  matrix.add(0, 1, 1.0);
  matrix.add(1, 1, 1.0);
  matrix.add(1, 2, 1.0);
  return matrix;
}

TEST(PrimaryCheck, FindsNothingWrongWithIndependentAndSufficientPrimaries) {
  const Elimination elimination(chain_and_free(), std::vector<int>{1, 3});

  const PrimaryCheck check = check_primaries(elimination, {}, std::vector<double>(4, 1.0));

  EXPECT_EQ(check.missing, 0);
  EXPECT_TRUE(check.dependences.empty());
  EXPECT_TRUE(check.undetermined.empty());
  EXPECT_TRUE(check.completions.empty());
  EXPECT_TRUE(check.removals.empty());
}

TEST(PrimaryCheck, ListsEveryCompletionWhereOneMagnitudeIsMissing) {
  const Elimination elimination(chain_and_free(), std::vector<int>{3});

  const PrimaryCheck check = check_primaries(elimination, {}, std::vector<double>(4, 1.0));

  EXPECT_EQ(check.missing, 1);
  EXPECT_EQ(check.undetermined, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(check.completions, (std::vector<std::vector<int>>{{0}, {1}, {2}}));
}

// x_1 = 1000.1 x_4, x_2 = 1000 x_4, x_3 = x_1 - x_2 and x_0 = x_3 - 0.1 x_4: as typed x_0 is 0, in
// doubles 2e-14 times x_4.
TEST(PrimaryCheck, DeterminesWhatMovesNoMoreThanTheRoundingOfTheNumbers) {
  SparseMatrix matrix{.rows = 4, .columns = 5, .entries = {}};
  for (int row = 0; row < 4; ++row) {
    matrix.add(row, row, 1.0);
  }
  matrix.add(0, 3, -1.0);
  matrix.add(0, 4, 0.1);
  matrix.add(1, 4, -1000.1);
  matrix.add(2, 4, -1000.0);
  matrix.add(3, 1, -1.0);
  matrix.add(3, 2, 1.0);
  const Elimination elimination(matrix, {});
  const std::vector<double> units(5, 1.0);

  EXPECT_EQ(check_primaries(elimination, {.share = kDataRounding}, units).undetermined,
            (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(check_primaries(elimination, {}, units).undetermined,
            (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(PrimaryCheck, LeavesDependentPairsOutOfTheCompletions) {
  const Elimination elimination(chain_and_free(), {});

  const PrimaryCheck check = check_primaries(elimination, {}, std::vector<double>(4, 1.0));

  EXPECT_EQ(check.missing, 2);
  EXPECT_EQ(check.completions, (std::vector<std::vector<int>>{{0, 3}, {1, 3}, {2, 3}}));
}

// 1200 free pairs, whose motions would be 3.6 million numbers, and as many magnitudes that are
// zero.
TEST(PrimaryCheck, NamesWhatIsOpenWhereVeryMuchIs) {
  constexpr int kPairs = 1200;
  SparseMatrix matrix = equal_pairs(kPairs);
  for (int i = 0; i < kPairs; ++i) {
    matrix.add(matrix.rows++, matrix.columns++, 2.0);
  }
  const Elimination elimination(matrix, {});

  const PrimaryCheck check = check_primaries(elimination, {}, std::vector<double>(3 * kPairs, 1.0));

  std::vector<int> open(2 * kPairs);
  std::iota(open.begin(), open.end(), 0);
  EXPECT_EQ(check.missing, kPairs);
  EXPECT_EQ(check.undetermined, open);
  EXPECT_EQ(check.candidates, open);
  EXPECT_TRUE(check.completions.empty());
}

TEST(PrimaryCheck, NamesTheRelationBetweenDependentPrimaries) {
  const Elimination elimination(chain_and_free(), std::vector<int>{0, 2, 3});

  const PrimaryCheck check = check_primaries(elimination, {}, std::vector<double>(4, 1.0));

  // x_0 - x_2 = 0, up to a factor.
  ASSERT_EQ(check.dependences.size(), 1U);
  const std::vector<DependenceTerm>& terms = check.dependences[0].terms;
  ASSERT_EQ(terms.size(), 2U);
  EXPECT_EQ(terms[0].index, 0);
  EXPECT_EQ(terms[1].index, 2);
  EXPECT_EQ(terms[1].coefficient, -terms[0].coefficient);
  EXPECT_EQ(check.dependences[0].constant, 0.0);
}

TEST(PrimaryCheck, NamesTheConstantThatARightHandSideAddsToTheRelation) {
  const Elimination elimination(chain_and_free(), std::vector<int>{0, 2, 3});

  // x_0 + x_1 = 5 and x_1 + x_2 = 3, so x_0 - x_2 = 2; x_0 counts in 10, so 1/10 x_0 - x_2 = 2.
  const PrimaryCheck check = check_primaries(
      elimination, {}, std::vector<double>{10.0, 1.0, 1.0, 1.0}, std::vector<double>{5.0, 3.0});

  ASSERT_EQ(check.dependences.size(), 1U);
  const Dependence& dependence = check.dependences[0];
  EXPECT_DOUBLE_EQ(dependence.constant / dependence.terms.at(0).coefficient, 20.0);
  EXPECT_DOUBLE_EQ(dependence.constant / dependence.terms.at(1).coefficient, -2.0);
}

using Sets = std::vector<std::vector<int>>;

TEST(PrimaryCheck, ProposesEveryMagnitudeOfOneRelationForRemoval) {
  const Elimination elimination(chain_and_free(), std::vector<int>{0, 1, 3});

  const PrimaryCheck check = check_primaries(elimination, {}, std::vector<double>(4, 1.0));

  EXPECT_EQ(check.removals, (Sets{{0}, {1}}));
}

// Of each pair one must go: those that no actuator drives before those that one drives.
TEST(PrimaryCheck, ProposesForRemovalOneMagnitudeARelation) {
  const Elimination elimination(equal_pairs(2), std::vector<int>{0, 1, 2, 3});

  const PrimaryCheck check =
      check_primaries(elimination, {}, std::vector<double>(4, 1.0), {}, std::vector<int>{0, 3});

  EXPECT_EQ(check.removals, (Sets{{1, 2}, {0, 2}, {1, 3}, {0, 3}}));
}

TEST(PrimaryCheck, ProposesMagnitudesOfActuatorsFirst) {
  const Elimination elimination(equal_pairs(2), {});

  const PrimaryCheck check =
      check_primaries(elimination, {}, std::vector<double>(4, 1.0), {}, std::vector<int>{3});

  EXPECT_EQ(check.completions, (Sets{{3, 0}, {3, 1}, {0, 2}, {1, 2}}));
}

TEST(PrimaryCheck, CountsMagnitudesFromTheFirstColumn) {
  const Elimination elimination(chain_and_free(), {});

  const PrimaryCheck check =
      check_primaries(elimination, {.first_column = 2}, std::vector<double>(2, 1.0));

  EXPECT_EQ(check.undetermined, (std::vector<int>{0, 1}));
  EXPECT_EQ(check.completions, (std::vector<std::vector<int>>{{0, 1}}));
}

TEST(PrimaryCheck, ProposesAtMostFiveCompletions) {
  const Elimination elimination(equal_pairs(3), {});

  const PrimaryCheck check = check_primaries(elimination, {}, std::vector<double>(6, 1.0));

  EXPECT_EQ(check.completions,
            (std::vector<std::vector<int>>{{0, 2, 4}, {0, 2, 5}, {0, 3, 4}, {0, 3, 5}, {1, 2, 4}}));
}

// Of the 40 million choices of 14 out of 28 only 16384 take one magnitude of each pair.
TEST(PrimaryCheck, ProposesCompletionsWhereMostChoicesAreDependent) {
  const Elimination elimination(equal_pairs(14), {});

  const PrimaryCheck check = check_primaries(elimination, {}, std::vector<double>(28, 1.0));

  EXPECT_EQ(check.missing, 14);
  ASSERT_EQ(check.completions.size(), 5U);
  EXPECT_EQ(check.completions[0],
            (std::vector<int>{0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26}));
}

}  // namespace
}  // namespace kinestat
