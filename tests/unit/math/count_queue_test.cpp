#include "math/elimination/internal/count_queue.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace kinestat {
namespace {

TEST(CountQueue, IsEmptyBeforeItemsAreAdded) {
  CountQueue queue(3);
  queue.change(1, 2);

  EXPECT_EQ(queue.take(), std::nullopt);
}

TEST(CountQueue, GivesEachItemAwayOnce) {
  CountQueue queue(2);
  queue.add(0);
  queue.add(1);
  queue.change(0, 1);

  EXPECT_EQ(queue.take(), 1);
  queue.change(1, -1);
  EXPECT_EQ(queue.take(), 0);
  EXPECT_EQ(queue.take(), std::nullopt);
}

class CountQueues : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Seed, CountQueues, ::testing::Range(0, 10));

// Against a search of all items, while counts of all of them rise and fall.
TEST_P(CountQueues, GiveAwayAnItemWithTheSmallestCount) {
  constexpr int kItems = 50;
  Random random(static_cast<std::uint64_t>(GetParam()));
  CountQueue queue(kItems);
  std::vector<int> counts(kItems, 0);
  std::set<int> waiting;
  for (int i = 0; i < kItems; ++i) {
    counts[static_cast<std::size_t>(i)] = random.whole(0, 9);
    queue.change(i, counts[static_cast<std::size_t>(i)]);
    queue.add(i);
    waiting.insert(i);
  }

  while (!waiting.empty()) {
    for (int i = 0; i < 30; ++i) {
      const int item = random.whole(0, kItems - 1);
      int& count = counts[static_cast<std::size_t>(item)];
      const int by = random.whole(-std::min(count, 3), 3);
      count += by;
      queue.change(item, by);
    }
    const auto count_of = [&](int item) { return counts[static_cast<std::size_t>(item)]; };
    const int smallest = count_of(*std::ranges::min_element(waiting, {}, count_of));

    const std::optional<int> item = queue.take();

    ASSERT_TRUE(item.has_value());
    ASSERT_EQ(waiting.erase(*item), 1U);
    ASSERT_EQ(count_of(*item), smallest);
  }
  EXPECT_EQ(queue.take(), std::nullopt);
}

}  // namespace
}  // namespace kinestat
