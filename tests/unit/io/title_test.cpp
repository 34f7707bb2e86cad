#include "io/title.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(Title, IsPutTogetherOfTextsNumbersAndOtherTitles) {
  const Title motion = "'motion'";
  const Title trace("'{0}' of {1}", std::string_view("trace"), &motion);
  const Title point("trace point {0} of {1}", std::size_t{2}, &trace);

  EXPECT_EQ(point.text(), "trace point 2 of 'trace' of 'motion'");
  EXPECT_EQ(fmt::format("{} is empty", trace), "'trace' of 'motion' is empty");
}

TEST(Title, TakesATextAsItStands) {
  EXPECT_EQ(Title("coupling '{0}'").text(), "coupling '{0}'");
}

TEST(Title, IsEmptyIfNothingIsCalledByIt) {
  EXPECT_TRUE(Title().empty());
  EXPECT_TRUE(Title("").empty());
  EXPECT_FALSE(Title("the tail").empty());
  EXPECT_EQ(Title().text(), "");
}

}  // namespace
}  // namespace kinestat
