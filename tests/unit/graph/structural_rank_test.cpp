#include "graph/structural_rank.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "graph/matching.hpp"
#include "math/elimination/exact_elimination.hpp"
#include "support/random.hpp"

namespace kinestat {
namespace {

TEST(StructuralRank, OfNoRowsIsZero) {
  EXPECT_EQ(structural_rank({}, 3), 0);
}

TEST(StructuralRank, OfEmptyRowsIsZero) {
  EXPECT_EQ(structural_rank({{}, {}}, 3), 0);
}

TEST(StructuralRank, IsThatOfAFullMatrix) {
  EXPECT_EQ(structural_rank({{0, 1, 2}, {0, 1, 2}}, 3), 2);
}

TEST(StructuralRank, IsLessWhereRowsShareTooFewColumns) {
  EXPECT_EQ(structural_rank({{1}, {1, 2}, {2}, {0, 1, 2, 3}}, 4), 3);
}

// Row i has the columns i and i + 1, the last row column 0 alone: all pairs must be exchanged,
// along a path through a hundred thousand rows.
TEST(StructuralRank, FollowsLongPaths) {
  constexpr int kRows = 100'000;
  EntryPattern pattern;
  for (int r = 0; r + 1 < kRows; ++r) {
    pattern.push_back({r, r + 1});
  }
  pattern.push_back({0});

  EXPECT_EQ(structural_rank(pattern, kRows), kRows);
}

class StructuralRanks : public ::testing::TestWithParam<int> {
 protected:
  EntryPattern random_pattern() {
    EntryPattern pattern(static_cast<std::size_t>(random_.whole(1, 40)));
    for (std::vector<int>& row : pattern) {
      for (int i = random_.whole(0, 3); i > 0; --i) {
        row.push_back(random_.whole(0, column_count_ - 1));
      }
      std::ranges::sort(row);
      row.erase(std::unique(row.begin(), row.end()), row.end());
    }
    return pattern;
  }

  Random random_{static_cast<std::uint64_t>(GetParam())};
  int column_count_ = random_.whole(1, 40);
};

INSTANTIATE_TEST_SUITE_P(Seed, StructuralRanks, ::testing::Range(0, 40));

TEST_P(StructuralRanks, AreSizesOfLargestMatchings) {
  const EntryPattern pattern = random_pattern();

  const auto matched = find_matching(pattern, column_count_);

  EXPECT_EQ(structural_rank(pattern, column_count_),
            std::ranges::count_if(matched, [](const auto& offer) { return offer.has_value(); }));
}

// With entries drawn from a billion, chance lowers the rank by one in some million matrices.
TEST_P(StructuralRanks, AreRanksOfNearlyAllMatricesOfThePattern) {
  const EntryPattern pattern = random_pattern();
  ExactMatrix matrix{
      .rows = static_cast<int>(pattern.size()), .columns = column_count_, .entries = {}};
  for (int r = 0; r < matrix.rows; ++r) {
    for (const int c : pattern[static_cast<std::size_t>(r)]) {
      matrix.entries.push_back(
          {.row = r, .column = c, .value = Rational(random_.whole(1, 1'000'000'000))});
    }
  }

  EXPECT_EQ(structural_rank(pattern, column_count_), ExactElimination(matrix, {}).rank());
}

}  // namespace
}  // namespace kinestat
