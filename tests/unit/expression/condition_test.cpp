#include "expression/condition.hpp"

#include <string>

#include <gtest/gtest.h>

#include "expression/exact.hpp"
#include "expression/parameters.hpp"
#include "expression/slots.hpp"

namespace kinestat {
namespace {

// Teeth of a planetary train, an angle and a length.
std::vector<Parameter> parameters_of_train() {
  const std::vector<std::pair<std::string, std::string>> lines = {
      {"N1", "24"}, {"N2", "18"}, {"N3", "60"}, {"zero", "0"}, {"alpha", "20 deg"}, {"r", "5 mm"}};
  std::vector<Parameter> result;
  for (const auto& [name, value] : lines) {
    result.push_back({name, std::get<Expression>(parse_expression(value)), {}});
  }
  return result;
}

template <class Number>
std::variant<bool, ExpressionError> answer(std::string_view text) {
  static const BasicParameterValues<Number> values =
      evaluate_parameters<Number>(parameters_of_train());
  const auto parsed = parse_condition(text);
  if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
    return *error;
  }
  return evaluate_condition<Number>(
      std::get<Condition>(parsed), values.table.lookup(), values.table.names());
}

struct ConditionCase {
  const char* name;
  const char* text;
  bool expected;
};

class Conditions : public testing::TestWithParam<ConditionCase> {};

TEST_P(Conditions, HoldForDoubleAsTheyRead) {
  const auto result = answer<double>(GetParam().text);

  ASSERT_TRUE(std::holds_alternative<bool>(result)) << std::get<ExpressionError>(result).message;
  EXPECT_EQ(std::get<bool>(result), GetParam().expected);
}

TEST_P(Conditions, HoldForExactAsTheyRead) {
  const auto result = answer<Exact>(GetParam().text);

  ASSERT_TRUE(std::holds_alternative<bool>(result)) << std::get<ExpressionError>(result).message;
  EXPECT_EQ(std::get<bool>(result), GetParam().expected);
}

std::string name_of_condition(const testing::TestParamInfo<ConditionCase>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Comparisons,
    Conditions,
    testing::Values(ConditionCase{"ring_of_the_train", "N3 == N1 + 2*N2", true},
                    ConditionCase{"not_equal", "N1 == N2", false},
                    ConditionCase{"unequal", "N1 != N2", true},
                    ConditionCase{"equal_is_not_unequal", "N1 != 24", false},
                    ConditionCase{"less", "N2 < N1", true},
                    ConditionCase{"equal_is_not_less", "24 < N1", false},
                    ConditionCase{"at_most", "24 <= N1", true},
                    ConditionCase{"greater", "N1 > 24", false},
                    ConditionCase{"at_least", "N1 >= 24", true},
                    ConditionCase{"no_blanks", "N1>=24", true},
                    ConditionCase{"negative_right_side", "N1>-1", true},
                    ConditionCase{"sign_after_equals", "N1==-24", false},
                    ConditionCase{"assembly", "mod(N1 + N3, 4) == 0", true},
                    ConditionCase{"common_divisor", "gcd(N1, N2) == 6", true},
                    ConditionCase{"units", "r < 1 cm", true},
                    ConditionCase{"angle", "alpha >= 14.5 deg", true},
                    ConditionCase{"degrees_and_radians", "alpha < 1 rad", true},
                    ConditionCase{"tenths", "0.1 + 0.2 == 0.3", true},
                    ConditionCase{"tenths_are_not_more", "0.1 + 0.2 > 0.3", false},
                    ConditionCase{"half_of_a_turn", "sin(30 deg) == 0.5", true},
                    ConditionCase{"root", "sqrt(2)^2 == 2", true}),
    name_of_condition);

INSTANTIATE_TEST_SUITE_P(
    Connectives,
    Conditions,
    testing::Values(ConditionCase{"and_true", "1 < 2 and 2 < 3", true},
                    ConditionCase{"and_false", "1 < 2 and 3 < 2", false},
                    ConditionCase{"or_true", "2 < 1 or 2 < 3", true},
                    ConditionCase{"or_false", "2 < 1 or 3 < 2", false},
                    ConditionCase{"not", "not 2 < 1", true},
                    ConditionCase{"not_not", "not not 2 < 1", false},
                    ConditionCase{"and_binds_before_or", "1 < 2 or 1 < 2 and 2 < 1", true},
                    ConditionCase{"not_binds_first", "not 1 < 2 or 1 < 2", true},
                    ConditionCase{"parentheses", "not (1 < 2 or 1 < 2)", false},
                    ConditionCase{"group_first", "(1 < 2 or 1 < 2) and 2 < 1", false},
                    ConditionCase{"nested_groups", "((1 < 2) and (not (2 < 1)))", true},
                    ConditionCase{"group_of_a_value", "(N1 + N2)/2 == 21", true},
                    ConditionCase{"both_sides_grouped", "(N1 + N2) == (42)", true},
                    ConditionCase{"function_in_a_group", "(max(N1, N2) == 24)", true},
                    ConditionCase{"and_stops", "zero != 0 and N1/zero > 2", false},
                    ConditionCase{"or_stops", "zero == 0 or N1/zero > 2", true}),
    name_of_condition);

TEST(Condition, NamesComeOnceInTheOrderOfFirstUse) {
  const auto parsed = parse_condition("b == a and sin(c) < b");

  const auto names = std::get<Condition>(parsed).names();

  EXPECT_EQ((std::vector<std::string>(names.begin(), names.end())),
            (std::vector<std::string>{"b", "a", "c"}));
}

TEST(Condition, AsksQuestionsOfWhatIsNoNumber) {
  const auto parsed = parse_condition("not (assembles(outer planet) or N1 < 2) and clears( p )");

  const auto& condition = std::get<Condition>(parsed);
  ASSERT_EQ(condition.questions().size(), 2U);
  EXPECT_EQ(condition.questions()[0].word, "assembles");
  EXPECT_EQ(condition.questions()[0].of, "outer planet");
  EXPECT_EQ(condition.questions()[0].offset, 5);
  EXPECT_EQ(condition.questions()[0].length, 23);
  EXPECT_EQ(condition.questions()[1].of, "p");
  EXPECT_EQ(condition.names().size(), 1U);  // what is asked about is no parameter
}

TEST(Condition, AnswersQuestionsWhenTheirTurnComes) {
  const auto parsed = parse_condition("(a > 1 and not assembles(p)) or clears(p)");
  int asked = 0;
  const auto answer_of = [&](const ConditionQuestion& question) {
    const bool is_of_assembly = question.word == "assembles";
    return SlotAnswer{.slots = {is_of_assembly ? 3 : 4},
                      .holds = [&asked, is_of_assembly](const Slots&, std::vector<Quantity>&) {
                        ++asked;
                        return is_of_assembly ? std::optional(false) : std::nullopt;
                      }};
  };
  const SlotCondition condition(
      std::get<Condition>(parsed), [](const std::string&) { return 0; }, answer_of);
  std::vector<Quantity> scratch;

  EXPECT_EQ((std::vector<int>(condition.slots().begin(), condition.slots().end())),
            (std::vector<int>{0, 3, 4}));
  EXPECT_EQ(condition.holds({.values = {{2.0, {}}}, .has_value = {true}}, scratch), true);
  EXPECT_EQ(asked, 1);  // what the other says does not matter
  EXPECT_EQ(condition.holds({.values = {{0.0, {}}}, .has_value = {true}}, scratch), std::nullopt);
  EXPECT_EQ(asked, 2);
}

TEST(Condition, DefaultHolds) {
  EXPECT_EQ(std::get<bool>(evaluate_condition({}, no_names)), true);
}

TEST(Condition, TenDigitsBelowTheToleranceAreEqualForDouble) {
  EXPECT_EQ(std::get<bool>(answer<double>("1 == 1 + 1e-14")), true);
}

TEST(Condition, AnyDifferenceCountsWhereBothAreExact) {
  EXPECT_EQ(std::get<bool>(answer<Exact>("1 == 1 + 1e-14")), false);
  EXPECT_EQ(std::get<bool>(answer<Exact>("1 < 1 + 1e-14")), true);
}

TEST(Condition, DigitsOfPiAreComparedWithTheTolerance) {
  EXPECT_EQ(std::get<bool>(answer<Exact>("pi == 3.141592653589793")), true);
}

TEST(Condition, CancelledTenthsAreZeroWhereTheyAreExact) {
  EXPECT_EQ(std::get<bool>(answer<Exact>("0.1 + 0.2 - 0.3 == 0")), true);
}

struct ConditionFault {
  const char* name;
  std::string text;
  int offset;
  int length;
  const char* code;
  const char* message;
  const char* hint;
};

class ConditionFaults : public testing::TestWithParam<ConditionFault> {};

TEST_P(ConditionFaults, AreNamedAtTheirPlace) {
  const auto result = answer<double>(GetParam().text);

  ASSERT_TRUE(std::holds_alternative<ExpressionError>(result));
  const auto& error = std::get<ExpressionError>(result);
  EXPECT_EQ(error.offset, GetParam().offset);
  EXPECT_EQ(error.length, GetParam().length);
  EXPECT_EQ(error.code, GetParam().code);
  EXPECT_NE(error.message.find(GetParam().message), std::string::npos) << error.message;
  EXPECT_NE(error.hint.find(GetParam().hint), std::string::npos) << error.hint;
}

std::string name_of_condition_fault(const testing::TestParamInfo<ConditionFault>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Operators,
    ConditionFaults,
    testing::Values(
        ConditionFault{"single_equals", "N1 = 24", 3, 1, "E0308", "'='", "write == to compare"},
        ConditionFault{"spaced_equals", "N1 = = 24", 3, 1, "E0308", "'='", "write =="},
        ConditionFault{"three_equals", "N1 === 24", 3, 3, "E0308", "'==='", "write =="},
        ConditionFault{"reversed_at_most", "N1 =< 24", 3, 2, "E0308", "'=<'", "write <="},
        ConditionFault{"reversed_at_least", "N1 => 24", 3, 2, "E0308", "'=>'", "write >="},
        ConditionFault{"different", "N1 <> 24", 3, 2, "E0308", "'<>'", "write !="},
        ConditionFault{"exclamation_mark", "!(N1 == 2)", 0, 1, "E0308", "'!'", "write not"},
        ConditionFault{"ampersands", "N1 > 2 && N2 > 2", 7, 2, "E0308", "'&&'", "write and"},
        ConditionFault{"bars", "N1 > 2 || N2 > 2", 7, 2, "E0308", "'||'", "write or"},
        ConditionFault{"shift", "N1 << 2", 3, 2, "E0308", "'<<'", "comparisons are =="},
        ConditionFault{"capitals", "N1 > 2 AND N2 > 2", 7, 3, "E0308", "'AND'", "write and"},
        ConditionFault{
            "sign_of_mathematics", "N1 \xE2\x89\xA4 2", 3, 3, "E0308", "U+2264", "write <="},
        ConditionFault{"chain",
                       "10 < N1 < N2 + 3",
                       0,
                       16,
                       "E0308",
                       "chained",
                       "write 10 < N1 and N1 < N2 + 3"}),
    name_of_condition_fault);

INSTANTIATE_TEST_SUITE_P(
    Form,
    ConditionFaults,
    testing::Values(
        ConditionFault{"empty", "  ", 2, 0, "E0308", "empty", "N3 == N1 + 2*N2"},
        ConditionFault{"value", "N1 + 2", 0, 6, "E0308", "'N1 + 2' is a value", "compare it"},
        ConditionFault{"value_after_and", "N1 > 2 and N2", 11, 2, "E0308", "'N2' is a", "compare"},
        ConditionFault{"value_in_a_group", "(N1 > 2 and N2)", 12, 2, "E0308", "'N2' is a", ""},
        ConditionFault{"no_right_side", "N1 ==", 3, 2, "E0308", "value is missing after '=='", ""},
        ConditionFault{"no_left_side", "== 2", 0, 2, "E0308", "value is missing before '=='", ""},
        ConditionFault{"not_on_the_right", "N1 == not 2", 3, 2, "E0308", "missing after '=='", ""},
        ConditionFault{"ends_in_and", "1 < 2 and", 6, 3, "E0308", "missing after 'and'", ""},
        ConditionFault{"begins_with_or", "or 1 < 2", 0, 2, "E0308", "missing before 'or'", ""},
        ConditionFault{"lonely_not", "not", 0, 3, "E0308", "condition is missing after 'not'", ""},
        ConditionFault{"not_in_the_middle", "1 < 2 not 1 < 2", 6, 3, "E0308", "'and' or 'or'", ""},
        ConditionFault{
            "question_of_nothing", "clears()", 0, 8, "E0308", "lacks the name", "clears("},
        ConditionFault{"open_question", "clears(p", 6, 1, "E0308", "'(' is not closed", "')'"},
        ConditionFault{
            "compared_question", "clears(p) == 1", 0, 9, "E0308", "a condition, not a", "join"},
        ConditionFault{"open_group", "(1 < 2", 0, 1, "E0308", "'(' is not closed", "')'"},
        ConditionFault{"closing_only", "1 < 2)", 5, 1, "E0308", "closes nothing", "remove"},
        ConditionFault{
            "sum_of_conditions", "(1 < 2) + 1 > 1", 0, 7, "E0308", "'(1 < 2)' is a", "join"},
        ConditionFault{
            "comparison_of_conditions", "(1 < 2) == (2 < 3)", 0, 7, "E0308", "not a value", "join"},
        ConditionFault{"comparison_in_a_value", "2*(1 < 2) > 1", 5, 1, "E0308", "'<' compares", ""},
        ConditionFault{"faulty_value", "N1 == 2*(3 +", 11, 1, "E0308", "missing after '+'", ""},
        ConditionFault{"too_long", std::string(4097, '1'), 0, 4096, "E0210", "condition", ""},
        ConditionFault{"too_deep",
                       std::string(65, '(') + "1 < 2" + std::string(65, ')'),
                       64,
                       1,
                       "E0210",
                       "nested too deeply",
                       ""}),
    name_of_condition_fault);

INSTANTIATE_TEST_SUITE_P(
    Values,
    ConditionFaults,
    testing::Values(ConditionFault{"dimensions",
                                   "1 < 2 and r > 3",
                                   10,
                                   5,
                                   "E0309",
                                   "a length and a bare number cannot be compared",
                                   "write a unit"},
                    ConditionFault{"unknown_name", "N1 == N9", 6, 2, "E0311", "'N9'", "'N1'"},
                    ConditionFault{
                        "division", "2 < 1/(N1 - 24)", 7, 7, "E0316", "division by zero", ""}),
    name_of_condition_fault);

TEST(Condition, LongChainOfConnectivesIsRead) {
  std::string text = "1<2";
  while (text.size() < 4080) {
    text += " and 1<2";
  }

  EXPECT_EQ(std::get<bool>(answer<Exact>(text)), true);
}

TEST(Condition, ManyNegationsNeedNoStack) {
  std::string text;
  for (int i = 0; i < 1000; ++i) {
    text += "not ";
  }

  EXPECT_EQ(std::get<bool>(answer<double>(text + "1 < 2")), true);
}

}  // namespace
}  // namespace kinestat
