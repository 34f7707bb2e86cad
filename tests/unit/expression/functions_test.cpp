#include "expression/functions.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(Functions, EveryListedNameIsFoundUnderItsOwnName) {
  ASSERT_EQ(function_names().size(), 21U);
  for (const std::string& name : function_names()) {
    ASSERT_NE(find_function(name), nullptr) << name;
    EXPECT_EQ(name_of(find_function(name)->function), name);
  }
}

TEST(Functions, UnknownNameIsNone) {
  EXPECT_EQ(find_function("sine"), nullptr);
}

class ReservedNames : public testing::TestWithParam<const char*> {};

TEST_P(ReservedNames, AreNotForParameters) {
  EXPECT_TRUE(is_reserved_name(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Table,
                         ReservedNames,
                         testing::Values("m", "N", "rpm", "sin", "min", "pi", "and", "or", "not"));

TEST(Functions, OrdinaryNameIsNotReserved) {
  EXPECT_FALSE(is_reserved_name("N1"));
}

}  // namespace
}  // namespace kinestat
