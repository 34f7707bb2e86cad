#include "studies/compare/place_index.hpp"

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(PlaceIndex, FindsNothingWhereNothingIs) {
  EXPECT_FALSE(PlaceIndex().find(1, [](std::uint32_t) { return true; }));
}

TEST(PlaceIndex, TellsItemsOfOneHashApart) {
  PlaceIndex index;
  for (const std::uint32_t item : {3U, 4U, 5U}) {
    index.add(7, item);
  }

  EXPECT_EQ(index.find(7, [](std::uint32_t item) { return item == 5; }), 5U);
  EXPECT_FALSE(index.find(7, [](std::uint32_t item) { return item == 6; }));
  EXPECT_FALSE(index.find(8, [](std::uint32_t) { return true; }));
}

TEST(PlaceIndex, LooksAtOneItemForEachPlace) {
  constexpr std::uint32_t kCount = 200'000;
  const auto hash_of = [](std::uint32_t item) {
    return std::hash<std::string>()("/cases/M" + std::to_string(item) + "/ratio");
  };
  PlaceIndex index;
  for (std::uint32_t item = 0; item < kCount; ++item) {
    index.add(hash_of(item), item);
  }

  std::size_t looks = 0;
  for (std::uint32_t item = 0; item < kCount; ++item) {
    const auto found = index.find(hash_of(item), [&](std::uint32_t one) {
      ++looks;
      return one == item;
    });
    ASSERT_EQ(found, item);
  }

  EXPECT_LT(looks, kCount + kCount / 1000);
}

}  // namespace
}  // namespace kinestat
