#include "core/spelling.hpp"

#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(InSmallLetters, LeavesWhatIsNotAscii) {
  EXPECT_EQ(in_small_letters("Zahnrad ÄZ_9"), "zahnrad Äz_9");
}

TEST(InWords, HasNoUnderscores) {
  EXPECT_EQ(in_words("dead_point_at_rest"), "dead point at rest");
}

TEST(NumberFrom, IsThatOfTheWholeText) {
  EXPECT_EQ(number_from<double>("-2.5e3"), -2500.0);
  EXPECT_EQ(number_from<std::uint64_t>("18446744073709551615"), UINT64_MAX);
}

TEST(NumberFrom, OfAnythingElseIsEmpty) {
  EXPECT_EQ(number_from<int>(""), std::nullopt);
  EXPECT_EQ(number_from<int>("12 "), std::nullopt);
  EXPECT_EQ(number_from<int>("+1"), std::nullopt);
  EXPECT_EQ(number_from<double>("1,5"), std::nullopt);
  EXPECT_EQ(number_from<std::uint64_t>("18446744073709551616"), std::nullopt);
}

}  // namespace
}  // namespace kinestat
