#include "math/sampling/counter_based_random.hpp"

#include <set>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

using Words = std::array<std::uint32_t, 4>;

// The known answers that Random123, the library of the authors of Philox, comes with.
TEST(Philox, GivesTheKnownAnswersOfItsAuthors) {
  constexpr std::uint32_t kAll = 0xFFFFFFFF;

  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8}));
  EXPECT_EQ(philox({kAll, kAll, kAll, kAll}, {kAll, kAll}),
            (Words{0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD}));
  EXPECT_EQ(philox({0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344}, {0xA4093822, 0x299F31D0}),
            (Words{0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1}));
}

TEST(CounterBasedRandom, DifferBySeedStreamAndIndex) {
  std::set<std::uint64_t> words;
  for (const std::uint64_t seed : {0ULL, 1ULL, 2ULL}) {
    for (const std::uint64_t stream : {0ULL, 1ULL, 1ULL << 32U}) {
      for (const std::uint64_t index : {0ULL, 1ULL, 1ULL << 32U}) {
        words.insert(CounterBasedRandom(seed).at(stream, index));
      }
    }
  }

  EXPECT_EQ(words.size(), 27U);
}

// The sum of squares has 63 degrees of freedom: a deviation of 11.2, and five of them are 56.
TEST(CounterBasedRandom, FallEvenlyInto64Parts) {
  constexpr int kParts = 64;
  constexpr int kEach = 1000;
  for (const std::uint64_t seed : {1ULL, 2ULL, 3ULL}) {
    const CounterBasedRandom bits(seed);
    std::array<int, kParts> counts = {};
    for (std::uint64_t i = 0; i < std::uint64_t{kParts} * kEach; ++i) {
      ++counts[bits.at(5, i) >> 58U];
    }
    double squares = 0.0;
    for (const int count : counts) {
      squares += static_cast<double>((count - kEach) * (count - kEach)) / kEach;
    }
    EXPECT_LT(squares, 63.0 + 56.0);
    EXPECT_GT(squares, 63.0 - 45.0);
  }
}

}  // namespace
}  // namespace kinestat
