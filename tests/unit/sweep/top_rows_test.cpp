#include "studies/sweep/top_rows.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "studies/sweep/sweep_counts.hpp"

namespace kinestat {

namespace {

std::vector<std::uint64_t> numbers_of(TopRows rows) {
  std::vector<std::uint64_t> numbers;
  for (const RankedRow& row : rows.take()) {
    numbers.push_back(row.number);
  }
  return numbers;
}

TEST(TopRows, KeepTheFirstOfEqualRowsWhateverTheOrder) {
  const std::vector<double> keys = {3.0, 1.0, 3.0, 2.0, 3.0, 2.0};
  for (const bool is_reversed : {false, true}) {
    SCOPED_TRACE(is_reversed);
    TopRows largest(3, RankOrder::largest);
    TopRows smallest(2, RankOrder::smallest);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const std::size_t k = is_reversed ? keys.size() - 1 - i : i;
      largest.add({.key = keys[k], .number = k, .text = {}});
      smallest.add({.key = keys[k], .number = k, .text = {}});
    }

    EXPECT_EQ(numbers_of(largest), (std::vector<std::uint64_t>{0, 2, 4}));
    EXPECT_EQ(numbers_of(smallest), (std::vector<std::uint64_t>{1, 3}));
  }
}

TEST(TopRows, AreReadBackToTheLastBit) {
  const std::vector<RankedRow> rows = {
      {.key = std::nextafter(0.1, 1.0), .number = 18446744073709551615U, .text = "a, b\n"},
      {.key = -1e-300, .number = 0, .text = "\n"}};

  const std::vector<RankedRow> read = read_rows(write_rows(rows));

  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].key, rows[0].key);
  EXPECT_EQ(read[0].number, rows[0].number);
  EXPECT_EQ(read[0].text, rows[0].text);
  EXPECT_EQ(read[1].key, rows[1].key);
  EXPECT_EQ(read[1].text, rows[1].text);
}

TEST(SweepCounts, AreReadBack) {
  const SweepCounts counts{.states = 100,
                           .excluded = {7, 0},
                           .rows = 186,
                           .dropped = {3, 0, 11},
                           .statuses = {{"solved", 180}, {"E0314", 6}}};

  const std::optional<SweepCounts> read = read_counts(write_counts(counts));

  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->states, counts.states);
  EXPECT_EQ(read->excluded, counts.excluded);
  EXPECT_EQ(read->rows, counts.rows);
  EXPECT_EQ(read->dropped, counts.dropped);
  EXPECT_EQ(read->statuses, counts.statuses);
  EXPECT_EQ(read->analysed(), 93U);
  EXPECT_FALSE(read_counts("states=1 excluded=x rows=1 dropped= statuses=").has_value());
}

}  // namespace

}  // namespace kinestat
