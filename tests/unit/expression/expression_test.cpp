#include "expression/expression.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

Expression parsed(std::string_view text) {
  auto result = parse_expression(text);
  if (const auto* error = std::get_if<ExpressionError>(&result)) {
    ADD_FAILURE() << text << ": " << error->message;
    return {};
  }
  return std::get<Expression>(std::move(result));
}

std::vector<std::string> names_of(const Expression& expression) {
  return {expression.names().begin(), expression.names().end()};
}

TEST(Expression, DefaultIsTheNumberZero) {
  const Expression zero;

  EXPECT_TRUE(zero.is_number());
  EXPECT_EQ(zero.nodes()[0].value, 0.0);
  EXPECT_EQ(zero.text_of(zero.nodes()[0]), "0");
}

TEST(Expression, TextStaysAsTyped) {
  EXPECT_EQ(parsed("  (N1+N2) / 2 ").text(), "  (N1+N2) / 2 ");
}

TEST(Expression, NamesComeOnceInTheOrderOfFirstUse) {
  EXPECT_EQ(names_of(parsed("b + a*b - sin(c_2)")), (std::vector<std::string>{"b", "a", "c_2"}));
}

TEST(Expression, UnitsFunctionsAndPiAreNoNames) {
  EXPECT_TRUE(parsed("sin(20 deg)*pi*mm + min").names().empty());
}

TEST(Expression, LiteralKeepsItsDigits) {
  const Expression expression = parsed("2 * 1.500e-3 mm");

  EXPECT_EQ(expression.text_of(expression.nodes()[1]), "1.500e-3");
}

TEST(Expression, PlainNumberKeepsItsSignAndDigits) {
  const Expression expression = parsed("-0.10");

  ASSERT_TRUE(expression.is_number());
  EXPECT_EQ(expression.text_of(expression.nodes()[0]), "-0.10");
  EXPECT_EQ(expression.nodes()[0].value, -0.1);
}

TEST(Expression, MinusZeroIsZero) {
  EXPECT_FALSE(std::signbit(parsed("-0.0").nodes()[0].value));
}

TEST(Expression, MeasureIsNoNumber) {
  EXPECT_FALSE(parsed("5 mm").is_number());
}

TEST(Expression, OperandsStandBeforeOperations) {
  const Expression expression = parsed("max(a, 2*b, -c^2) + hypot(3 mm, d)");

  for (std::size_t i = 0; i < expression.nodes().size(); ++i) {
    EXPECT_LT(expression.nodes()[i].left, static_cast<int>(i));
    EXPECT_LT(expression.nodes()[i].right, static_cast<int>(i));
  }
}

TEST(Expression, NodeOfACallCoversItsParentheses) {
  const Expression expression = parsed("1 + max(a, b )");

  EXPECT_EQ(expression.text_of(expression.nodes()[3]), "max(a, b )");
}

TEST(Expression, SixtyFourParenthesesAreAccepted) {
  EXPECT_EQ(parsed(std::string(64, '(') + "1" + std::string(64, ')')).nodes().size(), 1U);
}

TEST(Expression, LongestTextIsAccepted) {
  std::string text = "1";
  while (text.size() < 4095) {
    text += "+1";
  }

  EXPECT_EQ(parsed(text).nodes().size(), 4095U);
}

TEST(Expression, MegabytesOfSignsNeedNoStack) {
  const auto result = parse_expression(std::string(4'000'000, '-'));

  ASSERT_TRUE(std::holds_alternative<ExpressionError>(result));
  EXPECT_EQ(std::get<ExpressionError>(result).code, "E0210");
}

struct SyntaxFault {
  const char* name;
  std::string text;
  int offset;
  int length;
  const char* code;
  const char* message;
  const char* hint;
};

class SyntaxFaults : public testing::TestWithParam<SyntaxFault> {};

TEST_P(SyntaxFaults, AreNamedAtTheirPlace) {
  const auto result = parse_expression(GetParam().text);

  ASSERT_TRUE(std::holds_alternative<ExpressionError>(result));
  const auto& error = std::get<ExpressionError>(result);
  EXPECT_EQ(error.offset, GetParam().offset);
  EXPECT_EQ(error.length, GetParam().length);
  EXPECT_EQ(error.code, GetParam().code);
  EXPECT_NE(error.message.find(GetParam().message), std::string::npos) << error.message;
  EXPECT_NE(error.hint.find(GetParam().hint), std::string::npos) << error.hint;
}

std::string name_of_case(const testing::TestParamInfo<SyntaxFault>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Form,
    SyntaxFaults,
    testing::Values(
        SyntaxFault{"empty", "", 0, 0, "E0308", "empty", "20 deg"},
        SyntaxFault{"blank", "   ", 0, 0, "E0308", "empty", "20 deg"},
        SyntaxFault{"ends_in_operator", "N1 +", 3, 1, "E0308", "missing after '+'", "behind '+'"},
        SyntaxFault{"begins_with_operator", "*3", 0, 1, "E0308", "before '*'", "or remove it"},
        SyntaxFault{"two_operators", "2 / * 3", 4, 1, "E0308", "missing before '*'", ""},
        SyntaxFault{"double_star", "2**3", 2, 1, "E0308", "missing before '*'", "write ^"},
        SyntaxFault{"open_parenthesis", "2*(3 + 4", 2, 1, "E0308", "'(' is not closed", "')'"},
        SyntaxFault{"open_call", "sin(a", 3, 1, "E0308", "'(' is not closed", "')'"},
        SyntaxFault{"closing_parenthesis", "3 + 4)", 5, 1, "E0308", "')' closes nothing", "remove"},
        SyntaxFault{"empty_parentheses", "2*()", 3, 1, "E0308", "missing before ')'", ""},
        SyntaxFault{"empty_call", "sin()", 4, 1, "E0308", "missing before ')'", ""},
        SyntaxFault{"call_ends_in_comma", "max(1,)", 6, 1, "E0308", "missing before ')'", ""},
        SyntaxFault{"assignment", "N=3", 1, 1, "E0308", "'='", "value alone"},
        SyntaxFault{"comparison", "a < b", 2, 1, "E0308", "'<' compares", "a number or"},
        SyntaxFault{"comparison_of_two", "a >= b", 2, 2, "E0308", "'>=' compares", "'require'"},
        SyntaxFault{"equation", "a == b", 2, 2, "E0308", "'==' compares", "'require'"},
        SyntaxFault{"inequation", "a != b", 2, 2, "E0308", "'!=' compares", "'require'"},
        SyntaxFault{"connective", "a and b", 2, 3, "E0308", "'and' joins conditions", "'require'"},
        SyntaxFault{"negation", "not a", 0, 3, "E0308", "'not' joins conditions", "'require'"},
        SyntaxFault{"negated_group", "not(a)", 0, 3, "E0308", "'not' joins conditions", ""},
        SyntaxFault{"number_and_connective", "2 or 3", 2, 2, "E0308", "'or' joins", ""},
        SyntaxFault{"percent", "10 %", 3, 1, "E0308", "'%'", "write 10/100"},
        SyntaxFault{"percent_of_a_name", "a %", 2, 1, "E0308", "'%'", "0.05 for 5 percent"},
        SyntaxFault{"bars", "|a|", 0, 1, "E0308", "'|'", "abs( )"},
        SyntaxFault{"semicolon", "max(1; 2)", 5, 1, "E0308", "';'", "write ,"},
        SyntaxFault{"minutes_of_arc", "5'", 1, 1, "E0308", "'''", "5/60 deg"},
        SyntaxFault{"inches", "5\"", 1, 1, "E0308", "'\"'", "5 in"},
        SyntaxFault{"quoted_name", "'a'", 0, 1, "E0308", "'''", "without quotes"},
        SyntaxFault{"brackets", "[1]", 0, 1, "E0308", "'['", "( )"},
        SyntaxFault{"two_numbers", "2 3", 2, 1, "E0308", "operator is missing before '3'", "2*3"},
        SyntaxFault{"two_names", "a b", 2, 1, "E0308", "operator is missing before 'b'", "a*b"},
        SyntaxFault{"number_and_group", "2(3)", 1, 1, "E0308", "missing before '('", "write 2*(3)"},
        SyntaxFault{
            "number_and_nested_call", "2 max((a), b)*c", 2, 3, "E0308", "", "2*max((a), b) "},
        SyntaxFault{"name_and_open_call", "a sin(b", 2, 3, "E0308", "before 'sin'", "a*sin( ) for"},
        SyntaxFault{"number_and_long_group",
                    "2 (a + " + std::string(40, 'b') + ")",
                    2,
                    1,
                    "E0308",
                    "before '('",
                    "write 2*( ) for"},
        SyntaxFault{"name_and_unit", "a mm", 2, 2, "E0308", "missing before 'mm'", "write a*mm"},
        SyntaxFault{"two_units", "5 N m", 4, 1, "E0308", "operator is missing before 'm'", "*"},
        SyntaxFault{"two_groups", "(1)(2)", 3, 1, "E0308", "operator is missing before '('", "*"},
        SyntaxFault{"group_and_name", "(a+b) c", 6, 1, "E0308", "missing before 'c'", "* before"},
        SyntaxFault{"group_and_misspelled_unit", "(2) degre", 4, 5, "E0308", "'degre'", "'deg'"},
        SyntaxFault{"group_and_two_units", "(2) N m", 6, 1, "E0308", "missing before 'm'", "N*m"},
        SyntaxFault{"group_and_minimum", "(2) min(1, 2)", 4, 3, "E0308", "before 'min'", "*"},
        SyntaxFault{"power_and_unit", "2^3 mm", 4, 2, "E0308", "missing before 'mm'", "write 3*mm"},
        SyntaxFault{"unit_and_group", "5 mm (2)", 5, 1, "E0308", "missing before '('", "*"},
        SyntaxFault{"number_and_pi", "2 pi", 2, 2, "E0308", "missing before 'pi'", "write 2*pi"},
        SyntaxFault{"number_and_call", "3 sin(a)", 2, 3, "E0308", "before 'sin'", "write 3*sin(a)"},
        SyntaxFault{"comma_in_group", "(a,b)", 2, 1, "E0308", "','", ""},
        SyntaxFault{"function_without_values", "sin + 1", 0, 3, "E0308", "no values", "sin( )"},
        SyntaxFault{"root_without_parentheses", "sqrt 4", 0, 4, "E0308", "no values", "sqrt(4)"},
        SyntaxFault{"sine_without_parentheses",
                    "2*sin 30 deg + 1",
                    2,
                    3,
                    "E0308",
                    "no values",
                    "parentheses: sin(30 deg)"},
        SyntaxFault{"too_many_values", "2*sin(a, b)", 2, 3, "E0308", "one value, not 2", ""},
        SyntaxFault{"too_few_values", "atan2(a)", 0, 5, "E0308", "two values, not 1", ""},
        SyntaxFault{"single_maximum", "max(a)", 0, 3, "E0308", "two values or more", ""},
        SyntaxFault{"comma_in_value", "sqrt(1,5)", 0, 4, "E0308", "one value", "decimal point"},
        SyntaxFault{"unknown_function", "1 + sinn(a)", 4, 4, "E0311", "'sinn'", "'sin'"},
        SyntaxFault{"far_function", "a(b)", 0, 1, "E0311", "'a'", "functions are sin"},
        SyntaxFault{"product_like_a_call", "a(b)", 0, 1, "E0311", "'a'", "for a product write a*("},
        SyntaxFault{"65_parentheses",
                    std::string(65, '(') + "1" + std::string(65, ')'),
                    65,
                    1,
                    "E0210",
                    "nested too deeply",
                    "parameters"},
        SyntaxFault{"thousand_parentheses",
                    std::string(1000, '('),
                    65,
                    1,
                    "E0210",
                    "nested too deeply",
                    "parameters"},
        SyntaxFault{"too_long", std::string(4097, ' '), 0, 4096, "E0210", "4096", "parameters"}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Numbers,
    SyntaxFaults,
    testing::Values(
        SyntaxFault{"decimal_comma", "1,5", 0, 3, "E0308", "decimal comma", "write 1.5"},
        SyntaxFault{"decimal_comma_inside", "2*(1,5 mm)", 3, 3, "E0308", "comma", "write 1.5"},
        SyntaxFault{
            "comma_for_thousands", "1,000", 0, 5, "E0308", "comma", "or 1000 for thousands"},
        SyntaxFault{"comma_and_zero", "max(1,05, 2)", 4, 4, "E0308", "comma", "write 1.05"},
        SyntaxFault{"comma_and_point", "1,000.5", 0, 7, "E0308", "groups", "write 1000.5"},
        SyntaxFault{"many_commas", "12,000,000 mm", 0, 10, "E0308", "groups", "write 12000000"},
        SyntaxFault{"point_and_comma", "1.000,5", 0, 7, "E0308", "comma", "write 1000.5"},
        SyntaxFault{"spaced_thousands", "1 000", 0, 5, "E0308", "two numbers", "write 1000,"},
        SyntaxFault{"spaced_number", "2*10 500 mm", 2, 6, "E0308", "two numbers", "write 10500,"},
        SyntaxFault{"leading_zero", "017", 0, 3, "E0308", "begins with a zero", "write 17"},
        SyntaxFault{"leading_zeros", "2*00.5", 2, 4, "E0308", "begins with a zero", "write 0.5"},
        SyntaxFault{"only_zeros", "-00", 1, 2, "E0308", "begins with a zero", "write 0"},
        SyntaxFault{"hexadecimal", "0x1F", 0, 4, "E0308", "'0x1F'", "write 31"},
        SyntaxFault{"binary", "0b11", 0, 4, "E0308", "'0b11'", "write 3"},
        SyntaxFault{"octal", "2*0o17", 2, 4, "E0308", "'0o17'", "write 15"},
        SyntaxFault{"no_hexadecimal", "0xyz", 0, 4, "E0308", "'0xyz'", "digits 0-9"},
        SyntaxFault{"digit_groups", "1_000", 0, 5, "E0308", "groups", "write 1000"},
        SyntaxFault{"time_of_day", "12:30", 0, 5, "E0308", "time of day", "min"},
        SyntaxFault{"ratio", "10:1", 0, 4, "E0308", "time of day", "for a ratio write /"},
        SyntaxFault{"two_points", "1.2.3", 0, 5, "E0308", "more than one", "1234.5"},
        SyntaxFault{"too_large", "2*1e400", 2, 5, "E0308", "out of range", "1.8e308"},
        SyntaxFault{"too_large_plain", "1e400", 0, 5, "E0308", "out of range", "1.8e308"},
        SyntaxFault{"too_long_to_hold", std::string(400, '9'), 0, 400, "E0308", "out of range", ""},
        SyntaxFault{"too_small", "1e-400", 0, 6, "E0308", "underflow", "write 0"},
        SyntaxFault{"negative_too_small", "-1e-400", 1, 6, "E0308", "underflow", "write 0"},
        SyntaxFault{"not_a_number", ".nan", 0, 4, "E0308", "not a finite", "finite number"},
        SyntaxFault{"infinity", "-.INF", 1, 4, "E0308", "not a finite", "finite number"},
        SyntaxFault{"lonely_point", "2 + .", 4, 1, "E0308", "'.'", "decimal point"},
        SyntaxFault{"point_for_product", "5 N.m", 3, 1, "E0308", "'.'", "write *"},
        SyntaxFault{"misspelled_unit", "20 degre", 3, 5, "E0308", "unknown unit", "'deg'"},
        SyntaxFault{"unit_in_capitals", "20 MM", 3, 2, "E0308", "unknown unit 'MM'", "'mm'"},
        SyntaxFault{"unknown_prefix", "3 mNm", 2, 3, "E0308", "unknown unit 'mNm'", "'N*mm'"},
        SyntaxFault{"plural_unit", "3 newtons", 2, 7, "E0308", "unknown unit", "'N'"},
        SyntaxFault{"radius_is_no_radian", "2 radius", 2, 6, "E0308", "unknown", "write 2*radius"},
        SyntaxFault{"number_and_parameter", "2 N1", 2, 2, "E0308", "'N1'", "write 2*N1"},
        SyntaxFault{"missing_exponent", "2e", 1, 1, "E0308", "unknown unit 'e'", "2*e"}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Characters,
    SyntaxFaults,
    testing::Values(
        SyntaxFault{"cyrillic_s", "N1*\xD0\xA1\x31", 3, 2, "E0308", "'\xD0\xA1' (U+0421)", "A-Z"},
        SyntaxFault{"ordinal_for_degree", "20 \xC2\xBA", 3, 2, "E0308", "U+00BA", "deg"},
        SyntaxFault{"prime", "5\xE2\x80\xB2", 1, 3, "E0308", "U+2032", "5/60 deg"},
        SyntaxFault{"half", "\xC2\xBD", 0, 2, "E0308", "U+00BD", "write 1/2"},
        SyntaxFault{"dash", "3 \xE2\x80\x94 2", 2, 3, "E0308", "U+2014", "write -"},
        SyntaxFault{"full_width_digit", "\xEF\xBC\x97", 0, 3, "E0308", "U+FF17", "write 7"},
        SyntaxFault{"at_most_sign", "a \xE2\x89\xA4 2", 2, 3, "E0308", "U+2264", "write <="},
        SyntaxFault{"greek_pi", "2*\xCF\x80", 2, 2, "E0308", "U+03C0", "write pi"},
        SyntaxFault{"true_minus", "\xE2\x88\x92\x33", 0, 3, "E0308", "U+2212", "write -"},
        SyntaxFault{"no_break_space", "5\xC2\xA0mm", 1, 2, "E0308", "character U+00A0", "space"},
        SyntaxFault{"outside_the_basic_plane", "\xF0\x9F\x94\xA7", 0, 4, "E0308", "U+1F527", "A-Z"},
        SyntaxFault{"broken_utf8", "1 \xC3", 2, 1, "E0308", "0xC3", "UTF-8"},
        SyntaxFault{"stray_continuation", "\x80", 0, 1, "E0308", "0x80", "UTF-8"},
        SyntaxFault{"control_character", "1 + \x01", 4, 1, "E0308", "character U+0001", "names"}),
    name_of_case);

}  // namespace
}  // namespace kinestat
