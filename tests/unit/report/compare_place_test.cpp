#include "studies/compare/compare_place.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(Place, EscapesTheKeysOfItsWay) {
  EXPECT_EQ(place_below("/cases", "up/down ~ x"), "/cases/up~1down ~0 x");
}

TEST(Place, HasKeys) {
  EXPECT_EQ(keys_of("/cases/M1//ratio"),
            (std::vector<std::string_view>{"cases", "M1", "", "ratio"}));
  EXPECT_TRUE(keys_of("").empty());
}

TEST(Place, IsWithinItselfAndThoseAbove) {
  EXPECT_TRUE(is_within("/cases/M1/ratio", "/cases/M1/ratio"));
  EXPECT_TRUE(is_within("/cases/M1/ratio", "/cases"));
  EXPECT_TRUE(is_within("/cases/M1/ratio", ""));
}

TEST(Place, IsNotWithinThoseBelowOrBeside) {
  EXPECT_FALSE(is_within("/cases", "/cases/M1"));
  EXPECT_FALSE(is_within("/cases/M12/ratio", "/cases/M1"));
}

TEST(Place, IsWithinAPatternWithAnyKey) {
  EXPECT_TRUE(is_within("/cases/M1/ratio", "/cases/*/ratio"));
  EXPECT_FALSE(is_within("/cases/M1/power/ratio", "/cases/*/ratio"));
}

}  // namespace
}  // namespace kinestat
