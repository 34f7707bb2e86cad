#include "studies/sweep/best_rows.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "studies/sweep/sweep_counts.hpp"

namespace kinestat {

namespace {

std::vector<std::uint64_t> numbers_of(BestRows rows) {
  std::vector<std::uint64_t> numbers;
  for (const RankedRow& row : rows.take()) {
    numbers.push_back(row.number);
  }
  return numbers;
}

BestChoice best_by(std::uint64_t count, std::vector<RankOrder> orders) {
  BestChoice choice{.count = count, .criteria = {}};
  for (const RankOrder order : orders) {
    choice.criteria.push_back({.by = "x", .order = order});
  }
  return choice;
}

RankedRow row_of(const std::vector<double>& values,
                 const BestChoice& choice,
                 std::uint64_t number) {
  RankedRow row{.keys = {}, .number = number, .text = std::to_string(number)};
  for (std::size_t i = 0; i < values.size(); ++i) {
    row.keys[i] = rank_key(values[i], choice.criteria[i].order);
  }
  return row;
}

TEST(TopRows, KeepTheFirstOfEqualRowsWhateverTheOrder) {
  const std::vector<double> values = {3.0, 1.0, 3.0, 2.0, 3.0, 2.0};
  const BestChoice largest = best_by(3, {RankOrder::largest});
  const BestChoice smallest = best_by(2, {RankOrder::smallest});
  for (const bool is_reversed : {false, true}) {
    SCOPED_TRACE(is_reversed);
    BestRows first(largest);
    BestRows second(smallest);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t k = is_reversed ? values.size() - 1 - i : i;
      first.add(row_of({values[k]}, largest, k));
      second.add(row_of({values[k]}, smallest, k));
    }

    EXPECT_EQ(numbers_of(first), (std::vector<std::uint64_t>{0, 2, 4}));
    EXPECT_EQ(numbers_of(second), (std::vector<std::uint64_t>{1, 3}));
  }
}

TEST(RankKey, DiffersByMoreThanRoundingAlone) {
  for (const double value : {0.1, -7.25e300, 3e-300}) {
    SCOPED_TRACE(value);
    const double key = rank_key(value, RankOrder::largest);
    EXPECT_EQ(key, rank_key(value * (1.0 + 0x1p-50), RankOrder::largest));
    EXPECT_NE(key, rank_key(value * (1.0 + 0x1p-38), RankOrder::largest));
    EXPECT_EQ(-key, rank_key(value, RankOrder::smallest));
  }
  EXPECT_FALSE(std::signbit(rank_key(0.0, RankOrder::smallest)));
}

TEST(RankKey, HasTheRoundingOfTheTermsOfADifference) {
  const double rounding = 0.1 + 0.2 - 0.3;

  EXPECT_EQ(rank_key(rounding, RankOrder::smallest, 0.3), 0.0);
  EXPECT_EQ(rank_key(1e-9 + rounding, RankOrder::largest, 0.3),
            rank_key(1e-9, RankOrder::largest, 0.3));
  EXPECT_NE(rank_key(1e-9, RankOrder::largest, 0.3), rank_key(1.01e-9, RankOrder::largest, 0.3));
}

// By the definition: no other row is nowhere worse, and better somewhere or, as good, before it.
std::vector<std::uint64_t> front_by_definition(const std::vector<std::vector<double>>& rows,
                                               const std::vector<double>& signs) {
  std::vector<std::uint64_t> front;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto beats = [&](std::size_t j) {
      bool is_better_somewhere = j < i;
      for (std::size_t c = 0; c < signs.size(); ++c) {
        const double gain = signs[c] * (rows[j][c] - rows[i][c]);
        if (gain < 0.0) {
          return false;
        }
        is_better_somewhere = is_better_somewhere || gain > 0.0;
      }
      return is_better_somewhere;
    };
    bool is_beaten = false;
    for (std::size_t j = 0; j < rows.size() && !is_beaten; ++j) {
      is_beaten = j != i && beats(j);
    }
    if (!is_beaten) {
      front.push_back(i);
    }
  }
  return front;
}

// Small whole numbers, of which many are equal, and numbers that never are; near a trade-off, where
// fronts are long, and anywhere.
TEST(FrontRows, AreThoseThatNoOtherBeatsWhateverTheOrder) {
  std::mt19937_64 random(23);
  for (int trial = 0; trial < 60; ++trial) {
    const std::size_t criteria = 2 + trial % 2;
    const bool are_whole = trial % 3 == 0;
    const bool is_trade_off = trial % 4 < 2;
    const std::size_t count = trial < 4 ? 5000 : 1 + random() % 400;
    SCOPED_TRACE(testing::Message() << "trial " << trial << ": " << count << " rows");
    std::vector<RankOrder> orders;
    std::vector<double> signs;
    for (std::size_t c = 0; c < criteria; ++c) {
      orders.push_back(random() % 2 == 0 ? RankOrder::largest : RankOrder::smallest);
      signs.push_back(orders.back() == RankOrder::largest ? 1.0 : -1.0);
    }
    const BestChoice choice = best_by(0, orders);
    std::vector<std::vector<double>> rows(count, std::vector<double>(criteria));
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    for (std::vector<double>& row : rows) {
      double sum = 0.0;
      for (std::size_t c = 0; c < criteria; ++c) {
        row[c] = are_whole ? static_cast<double>(random() % 9) : anywhere(random);
        if (is_trade_off && c + 1 == criteria) {
          row[c] = -signs[c] * sum;
        }
        sum += signs[c] * row[c];
      }
    }
    std::vector<std::size_t> order(count);
    for (std::size_t i = 0; i < count; ++i) {
      order[i] = i;
    }
    std::shuffle(order.begin(), order.end(), random);

    // Through one, and through several, as chunks are: what each keeps goes to the last.
    BestRows front(choice);
    BestRows merged(choice);
    BestRows part(choice);
    for (std::size_t i = 0; i < count; ++i) {
      const RankedRow row = row_of(rows[order[i]], choice, order[i]);
      if (front.accepts(row.keys, row.number)) {
        front.add(row);
      }
      part.add(row);
      if (i % 97 == 96 || i + 1 == count) {
        for (RankedRow& kept : read_rows(write_rows(part.take()))) {
          merged.add(std::move(kept));
        }
      }
    }

    const std::vector<RankedRow> kept = front.take();
    EXPECT_TRUE(std::ranges::is_sorted(
        kept, [](const RankedRow& a, const RankedRow& b) { return a.keys > b.keys; }));
    std::vector<std::uint64_t> numbers;
    for (const RankedRow& row : kept) {
      EXPECT_EQ(row.text, std::to_string(row.number));
      numbers.push_back(row.number);
    }
    EXPECT_EQ(numbers_of(merged), numbers);
    std::ranges::sort(numbers);
    EXPECT_EQ(numbers, front_by_definition(rows, signs));
  }
}

TEST(RankedRow, IsReadBackToTheLastBit) {
  const std::vector<RankedRow> rows = {
      {.keys = {std::nextafter(0.1, 1.0), 0.0, -4.0},
       .number = 18446744073709551615U,
       .text = "a, b\n"},
      {.keys = {-1e-300, 1.0, 2.0}, .number = 0, .text = std::string("\n\0\xff\n", 4)},
      {.keys = {}, .number = 7, .text = ""}};

  const std::string text = write_rows(rows);
  const std::vector<RankedRow> read = read_rows(text);

  ASSERT_EQ(read.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(read[i].keys, rows[i].keys);
    EXPECT_EQ(read[i].number, rows[i].number);
    EXPECT_EQ(read[i].text, rows[i].text);
  }
  EXPECT_TRUE(read_rows(text.substr(0, text.size() - 1)).empty());
}

TEST(ReadFront, TakesCriteriaWithCommasBetweenThem) {
  const auto front = read_front(" efficiency,smallest  abs(max(ratio, 4) - 4) ,largest largest");

  ASSERT_TRUE(front.has_value());
  ASSERT_EQ(front->criteria.size(), 3U);
  EXPECT_EQ(front->criteria[0].text(), "largest efficiency");
  EXPECT_EQ(front->criteria[1].text(), "smallest abs(max(ratio, 4) - 4)");
  EXPECT_EQ(front->criteria[2].text(), "largest largest");
  const auto names = read_front("smallest, smallest_torque");
  ASSERT_TRUE(names.has_value());
  EXPECT_EQ(names->criteria[0].text(), "largest smallest");
  EXPECT_EQ(names->criteria[1].text(), "largest smallest_torque");
  for (const char* text :
       {"", "ratio", "ratio,", ",ratio", "a,b,c,d", "smallest ratio", "max(a, b)"}) {
    EXPECT_FALSE(read_front(text).has_value()) << text;
  }
}

TEST(SweepCounts, AreReadBack) {
  const SweepCounts counts{.states = 100,
                           .excluded = {7, 0},
                           .rows = 186,
                           .dropped = {3, 0, 11},
                           .unranked = 5,
                           .statuses = {{"solved", 180}, {"E0314", 6}}};

  const std::optional<SweepCounts> read = read_counts(write_counts(counts));

  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->states, counts.states);
  EXPECT_EQ(read->excluded, counts.excluded);
  EXPECT_EQ(read->rows, counts.rows);
  EXPECT_EQ(read->dropped, counts.dropped);
  EXPECT_EQ(read->unranked, counts.unranked);
  EXPECT_EQ(read->statuses, counts.statuses);
  EXPECT_EQ(read->analysed(), 93U);
  EXPECT_FALSE(read_counts("states=1 excluded=x rows=1 dropped= unranked=0 statuses=").has_value());
}

}  // namespace

}  // namespace kinestat
