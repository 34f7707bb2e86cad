#include "expression/parameters.hpp"

#include <gtest/gtest.h>

#include "expression/condition.hpp"

namespace kinestat {
namespace {

struct Line {
  std::string name;
  std::string value;
};

std::vector<Parameter> parameters(const std::vector<Line>& lines) {
  std::vector<Parameter> result;
  for (const Line& line : lines) {
    auto parsed = parse_expression(line.value);
    result.push_back({line.name, std::get<Expression>(std::move(parsed)), {}});
  }
  return result;
}

TEST(Parameters, AreEvaluatedInWhateverOrderTheyStand) {
  const auto list = parameters({{"c", "a + b"}, {"a", "2*b"}, {"b", "3 mm"}});

  const ParameterValues values = evaluate_parameters(list);

  ASSERT_TRUE(values.errors.empty());
  EXPECT_DOUBLE_EQ(values.table.find("c")->value, 0.009);
}

TEST(Parameters, KeepTheirDimension) {
  const auto list = parameters({{"alpha", "20 deg"}});

  EXPECT_EQ(evaluate_parameters(list).table.find("alpha")->dimension, (Dimension{0, 0, 0, 1}));
}

TEST(Parameters, UnknownNameHasNoValue) {
  EXPECT_EQ(evaluate_parameters({}).table.find("a"), nullptr);
}

TEST(Parameters, CircleIsListedFromItsFirstParameter) {
  const auto list = parameters({{"x", "1"}, {"a", "x + b"}, {"b", "2*c"}, {"c", "a"}});

  const ParameterValues values = evaluate_parameters(list);

  ASSERT_EQ(values.errors.size(), 1U);
  EXPECT_EQ(values.errors[0].parameter, 1);
  EXPECT_EQ(values.errors[0].error.code, "E0310");
  EXPECT_NE(values.errors[0].error.message.find("a -> b -> c -> a"), std::string::npos);
}

TEST(Parameters, OpenOnesMayNotFollowFromEachOther) {
  const auto list = parameters({{"c", "2*b"}, {"a", "3"}, {"b", "a + d"}, {"d", "1"}, {"e", "d"}});

  const std::vector<ParameterError> errors = find_dependent(list, std::vector<int>{0, 1, 4});

  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].parameter, 0);
  EXPECT_EQ(errors[0].error.code, "E0310");
  EXPECT_EQ(errors[0].error.message, "'c' is free and follows from 'a', which is free too");
  EXPECT_EQ(errors[0].error.hint, "write 'c: 2*b', or give it a value of its own");
}

TEST(Parameters, OpenOnesMayBeUsedByOthersAndUseOthers) {
  const auto list = parameters({{"a", "2*b"}, {"b", "3"}, {"c", "a"}});

  EXPECT_TRUE(find_dependent(list, std::vector<int>{0}).empty());
}

TEST(Parameters, CircleIsShownWhereItGoesOn) {
  const auto list = parameters({{"a", "1 + b"}, {"b", "a"}});

  const ParameterValues values = evaluate_parameters(list);

  ASSERT_EQ(values.errors.size(), 1U);
  EXPECT_EQ(values.errors[0].error.offset, 4);
  EXPECT_EQ(values.errors[0].error.length, 1);
}

TEST(Parameters, ParameterOfItselfIsACircle) {
  const auto list = parameters({{"a", "a + 1"}});

  const ParameterValues values = evaluate_parameters(list);

  ASSERT_EQ(values.errors.size(), 1U);
  EXPECT_NE(values.errors[0].error.message.find("a -> a"), std::string::npos);
}

TEST(Parameters, SeparateCirclesAreReportedEach) {
  const auto list = parameters({{"a", "b"}, {"c", "d"}, {"b", "a"}, {"d", "c"}});

  EXPECT_EQ(evaluate_parameters(list).errors.size(), 2U);
}

TEST(Parameters, WhatHangsOnACircleIsNotReported) {
  const auto list = parameters({{"user", "2*a"}, {"a", "b"}, {"b", "a"}});

  const ParameterValues values = evaluate_parameters(list);

  ASSERT_EQ(values.errors.size(), 1U);
  EXPECT_EQ(values.errors[0].parameter, 1);
}

TEST(Parameters, LongCircleIsCutShort) {
  std::vector<Line> lines;
  for (int i = 0; i < 20000; ++i) {
    lines.push_back({"p" + std::to_string(i), "p" + std::to_string((i + 1) % 20000)});
  }

  const ParameterValues values = evaluate_parameters(parameters(lines));

  ASSERT_EQ(values.errors.size(), 1U);
  EXPECT_NE(values.errors[0].error.message.find("p11 -> ... -> p0"), std::string::npos);
}

TEST(Parameters, LongChainNeedsNoStack) {
  std::vector<Line> lines;
  for (int i = 0; i < 20000; ++i) {
    lines.push_back({"p" + std::to_string(i), "1 + p" + std::to_string(i + 1)});
  }
  lines.push_back({"p20000", "0"});

  const ParameterValues values = evaluate_parameters(parameters(lines));

  ASSERT_TRUE(values.errors.empty());
  EXPECT_EQ(values.table.find("p0")->value, 20000.0);
}

TEST(Parameters, FaultyValueIsReportedOnceAtItsIndex) {
  const auto list = parameters({{"c", "b + 1"}, {"b", "a*2"}, {"a", "1/0"}});

  const ParameterValues values = evaluate_parameters(list);

  ASSERT_EQ(values.errors.size(), 1U);
  EXPECT_EQ(values.errors[0].parameter, 2);
  EXPECT_EQ(values.errors[0].error.code, "E0316");
}

TEST(Parameters, ErrorsComeInTheOrderOfTheList) {
  const auto list = parameters({{"a", "sqrt(0 - b)"}, {"b", "1"}, {"c", "1/0"}});

  const ParameterValues values = evaluate_parameters(list);

  ASSERT_EQ(values.errors.size(), 2U);
  EXPECT_EQ(values.errors[0].parameter, 0);
  EXPECT_EQ(values.errors[1].parameter, 2);
}

TEST(Parameters, UnknownNameSuggestsAParameter) {
  const auto list = parameters({{"crank", "1"}, {"rocker", "2*crnk"}});

  const ParameterValues values = evaluate_parameters(list);

  ASSERT_EQ(values.errors.size(), 1U);
  EXPECT_EQ(values.errors[0].error.code, "E0311");
  EXPECT_EQ(values.errors[0].error.hint, "did you mean 'crank'?");
}

TEST(Parameters, ExpressionOnAFailedParameterIsFailed) {
  const auto list = parameters({{"a", "1/0"}});
  const auto user = parameters({{"user", "a + 1"}});

  EXPECT_TRUE(evaluate_parameters(list).table.is_failed(user[0].value));
}

TEST(Parameters, ConditionOnAFailedParameterIsFailed) {
  const auto list = parameters({{"a", "1/0"}, {"b", "1"}});
  const auto condition = parse_condition("b > 0 and a > 0");

  const ParameterValues values = evaluate_parameters(list);

  EXPECT_TRUE(values.table.is_failed(std::get<Condition>(condition).names()));
}

TEST(Parameters, ThoseOfAConditionAreMarked) {
  const auto list = parameters({{"a", "1"}, {"b", "2"}});
  const auto condition = parse_condition("not b == 2");
  ParameterValues values = evaluate_parameters(list);

  values.table.mark_used(std::get<Condition>(condition).names());

  EXPECT_EQ(values.table.unused(), (std::vector<int>{0}));
}

TEST(Parameters, ExpressionOnAnUnknownNameIsNotFailed) {
  const auto list = parameters({{"a", "1"}});
  const auto user = parameters({{"user", "unknown + a"}});

  EXPECT_FALSE(evaluate_parameters(list).table.is_failed(user[0].value));
}

TEST(Parameters, ThoseThatNothingRefersToAreUnused) {
  const auto list = parameters({{"a", "1"}, {"b", "a"}, {"c", "2"}});

  EXPECT_EQ(evaluate_parameters(list).table.unused(), (std::vector<int>{1, 2}));
}

TEST(Parameters, ThoseUsedOutsideAreMarked) {
  const auto list = parameters({{"a", "1"}, {"b", "2"}});
  const auto user = parameters({{"user", "b^2"}});
  ParameterValues values = evaluate_parameters(list);

  values.table.mark_used(user[0].value);

  EXPECT_EQ(values.table.unused(), (std::vector<int>{0}));
}

}  // namespace
}  // namespace kinestat
