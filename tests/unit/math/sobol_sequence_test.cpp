#include "math/sampling/sobol_sequence.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

double share(std::uint64_t bits) {
  return static_cast<double>(bits >> 11U) / 9007199254740992.0;
}

// What the program of Joe and Kuo prints for 10 points of 3 dimensions.
TEST(SobolSequence, BeginsAsThatOfJoeAndKuo) {
  const std::vector<std::vector<double>> points = {{0, 0, 0},
                                                   {0.5, 0.5, 0.5},
                                                   {0.75, 0.25, 0.25},
                                                   {0.25, 0.75, 0.75},
                                                   {0.375, 0.375, 0.625},
                                                   {0.875, 0.875, 0.125},
                                                   {0.625, 0.125, 0.875},
                                                   {0.125, 0.625, 0.375},
                                                   {0.1875, 0.3125, 0.9375},
                                                   {0.6875, 0.8125, 0.4375}};
  const SobolSequence sequence(3, points.size());

  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t d = 0; d < 3; ++d) {
      EXPECT_EQ(share(sequence.at(i, d)), points[i][d]) << "point " << i << ", dimension " << d;
    }
  }
}

TEST(SobolSequence, HasAPointInEachPartOfEveryDimension) {
  constexpr std::uint64_t kParts = 256;
  const SobolSequence sequence(SobolSequence::kMostDimensions, 4 * kParts);
  for (std::size_t d = 0; d < SobolSequence::kMostDimensions; ++d) {
    for (const std::uint64_t from : {std::uint64_t{0}, 3 * kParts}) {
      std::vector<bool> is_hit(kParts, false);
      for (std::uint64_t i = 0; i < kParts; ++i) {
        is_hit[sequence.at(from + i, d) >> 56U] = true;
      }
      EXPECT_EQ(std::count(is_hit.begin(), is_hit.end(), true), 256) << "dimension " << d;
    }
  }
}

// Of 2^m points each rectangle of area 2^-m between halves of halves has one: a (0, m, 2)-net.
TEST(SobolSequence, HasAPointInEachRectangleOfItsFirstPlane) {
  constexpr unsigned kDigits = 8;
  const SobolSequence sequence(2, 1U << kDigits);
  for (unsigned across = 0; across <= kDigits; ++across) {
    std::vector<bool> is_hit(1U << kDigits, false);
    for (std::uint64_t i = 0; i < is_hit.size(); ++i) {
      const std::uint64_t column = across == 0 ? 0 : sequence.at(i, 0) >> (64U - across);
      const unsigned up = kDigits - across;
      const std::uint64_t row = up == 0 ? 0 : sequence.at(i, 1) >> (64U - up);
      is_hit[column << up | row] = true;
    }
    EXPECT_EQ(std::count(is_hit.begin(), is_hit.end(), true), 256) << across << " digits across";
  }
}

TEST(SobolSequence, IsTheSameWhateverItsLength) {
  const SobolSequence brief(5, 1000);
  const SobolSequence lengthy(9, 1'000'000'000'000);
  for (const std::uint64_t i : {0ULL, 1ULL, 2ULL, 511ULL, 512ULL, 999ULL}) {
    for (std::size_t d = 0; d < 5; ++d) {
      EXPECT_EQ(brief.at(i, d), lengthy.at(i, d));
    }
  }
}

}  // namespace
}  // namespace kinestat
