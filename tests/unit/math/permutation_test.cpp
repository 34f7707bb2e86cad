#include "math/sampling/permutation.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

std::vector<std::uint64_t> order_of(std::uint64_t size, std::uint64_t seed) {
  const Permutation permutation(size, CounterBasedRandom(seed), 0);
  std::vector<std::uint64_t> order;
  for (std::uint64_t i = 0; i < size; ++i) {
    order.push_back(permutation.at(i));
  }
  return order;
}

TEST(Permutation, HasEachNumberOnce) {
  for (const std::uint64_t size :
       {1ULL, 2ULL, 3ULL, 4ULL, 5ULL, 8ULL, 9ULL, 100ULL, 4096ULL, 4097ULL}) {
    std::vector<std::uint64_t> order = order_of(size, size);
    std::ranges::sort(order);
    for (std::uint64_t i = 0; i < size; ++i) {
      ASSERT_EQ(order[i], i);
    }
  }
}

TEST(Permutation, TakesSizesThatNobodyKeeps) {
  const Permutation permutation(999'999'999'989, CounterBasedRandom(1), 0);

  EXPECT_LT(permutation.at(0), 999'999'999'989U);
  EXPECT_NE(permutation.at(0), permutation.at(1));
}

// All 24 orders of four, by 24000 seeds: 23 degrees of freedom have a deviation of 6.8; ten of them
// are 68.
TEST(Permutation, HasNoFavouriteOrder) {
  std::map<std::vector<std::uint64_t>, int> counts;
  for (std::uint64_t seed = 0; seed < 24'000; ++seed) {
    ++counts[order_of(4, seed)];
  }
  double squares = 0.0;
  for (const auto& [order, count] : counts) {
    squares += static_cast<double>((count - 1000) * (count - 1000)) / 1000.0;
  }

  EXPECT_EQ(counts.size(), 24U);
  EXPECT_LT(squares, 23.0 + 68.0);
}

}  // namespace
}  // namespace kinestat
