#include "expression/exact.hpp"

#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "expression/evaluate.hpp"
#include "expression/parameters.hpp"

namespace kinestat {
namespace {

using ExactQuantity = BasicQuantity<Exact>;

const ExactQuantity* exact_parameter(std::string_view name) {
  static const ExactQuantity teeth{{24.0, PiRational{Rational(24), 0}}, {}};
  static const ExactQuantity root{{1.4142135623730951, std::nullopt}, {}};
  return name == "N1" ? &teeth : name == "root" ? &root : nullptr;
}

std::variant<ExactQuantity, ExpressionError> exactly_evaluated(std::string_view text) {
  auto parsed = parse_expression(text);
  if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
    return *error;
  }
  return evaluate<Exact>(std::get<Expression>(parsed), exact_parameter);
}

struct ExactCase {
  const char* name;
  std::string text;
  const char* factor;
  int pi_power = 0;
};

class ExactValues : public testing::TestWithParam<ExactCase> {};

TEST_P(ExactValues, AreFractionsTimesPowersOfPi) {
  const auto result = exactly_evaluated(GetParam().text);

  ASSERT_TRUE(std::holds_alternative<ExactQuantity>(result))
      << std::get<ExpressionError>(result).message;
  const Exact& number = std::get<ExactQuantity>(result).value;
  ASSERT_TRUE(number.exact.has_value()) << GetParam().text << " is only " << number.value;
  EXPECT_EQ(number.exact->factor, Rational(GetParam().factor));
  EXPECT_EQ(number.exact->pi_power, GetParam().pi_power);
}

std::string name_of_exact(const testing::TestParamInfo<ExactCase>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Numbers,
                         ExactValues,
                         testing::Values(ExactCase{"whole", "24", "24"},
                                         ExactCase{"tenth", "0.1", "1/10"},
                                         ExactCase{"signed_decimal", "-0.10", "-1/10"},
                                         ExactCase{"exponent", "1e-3", "1/1000"},
                                         ExactCase{"tenths_add_up", "0.1 + 0.2 - 0.3", "0"},
                                         ExactCase{"thirds_add_up", "1/3 + 1/3 + 1/3", "1"},
                                         ExactCase{
                                             "difference_of_large_numbers", "1e20 + 1 - 1e20", "1"},
                                         ExactCase{"power", "(2/3)^-3", "27/8"},
                                         ExactCase{"power_of_one", "1^1e9", "1"},
                                         ExactCase{"negation", "-(2 - 5)", "3"},
                                         ExactCase{"parameter", "N1/36", "2/3"},
                                         ExactCase{"longest_range", "5e-324*1e308*1e16", "5"}),
                         name_of_exact);

INSTANTIATE_TEST_SUITE_P(Units,
                         ExactValues,
                         testing::Values(ExactCase{"millimetre", "6 mm", "3/500"},
                                         ExactCase{"inch", "1 in", "127/5000"},
                                         ExactCase{"per_unit", "3 N/mm", "3000"},
                                         ExactCase{"unit_alone", "mm*5", "1/200"},
                                         ExactCase{"square_millimetre", "2 mm^2", "1/500000"},
                                         ExactCase{"degrees", "20 deg", "1/9", 1},
                                         ExactCase{"turns", "2.5 rev", "5", 1},
                                         ExactCase{"rpm", "1500 rpm", "50", 1},
                                         ExactCase{"radians", "0.5 rad", "1/2"},
                                         ExactCase{"pi", "pi/2", "1/2", 1},
                                         ExactCase{"square_of_pi", "pi*pi/4", "1/4", 2},
                                         ExactCase{"power_of_degrees", "(180 deg)^-2", "1", -2},
                                         ExactCase{"pi_cancels", "180 deg/pi", "1"},
                                         ExactCase{"angles_add_up", "20 deg + 0.5 rev", "10/9", 1},
                                         ExactCase{
                                             "zero_joins_any_power", "20 deg + 0 rad", "1/9", 1},
                                         ExactCase{"zero_has_no_pi", "0*pi + 2", "2"}),
                         name_of_exact);

// Values at whole parts of a turn: sin 30 deg = 1/2, cos 60 deg = 1/2, tan 45 deg = 1, and what
// follows from the symmetries of the circle.
INSTANTIATE_TEST_SUITE_P(
    Angles,
    ExactValues,
    testing::Values(ExactCase{"sin_0", "sin(0 deg)", "0"},
                    ExactCase{"sin_0_rad", "sin(0 rad)", "0"},
                    ExactCase{"sin_30", "sin(30 deg)", "1/2"},
                    ExactCase{"sin_90", "sin(90 deg)", "1"},
                    ExactCase{"sin_150", "sin(150 deg)", "1/2"},
                    ExactCase{"sin_180", "sin(pi*1 rad)", "0"},
                    ExactCase{"sin_210", "sin(210 deg)", "-1/2"},
                    ExactCase{"sin_270", "sin(270 deg)", "-1"},
                    ExactCase{"sin_330", "sin(-30 deg)", "-1/2"},
                    ExactCase{"sin_many_turns", "sin(1000 rev + 30 deg)", "1/2"},
                    ExactCase{"cos_0", "cos(0 deg)", "1"},
                    ExactCase{"cos_60", "cos(60 deg)", "1/2"},
                    ExactCase{"cos_90", "cos(90 deg)", "0"},
                    ExactCase{"cos_120", "cos(120 deg)", "-1/2"},
                    ExactCase{"cos_180", "cos(-180 deg)", "-1"},
                    ExactCase{"cos_300", "cos(300 deg)", "1/2"},
                    ExactCase{"tan_0", "tan(180 deg)", "0"},
                    ExactCase{"tan_45", "tan(45 deg)", "1"},
                    ExactCase{"tan_135", "tan(135 deg)", "-1"},
                    ExactCase{"tan_minus_45", "tan(-45 deg)", "-1"},
                    ExactCase{"asin", "asin(-0.5)", "-1/6", 1},
                    ExactCase{"asin_of_one", "asin(1)", "1/2", 1},
                    ExactCase{"acos", "acos(-1/2)", "2/3", 1},
                    ExactCase{"acos_of_one", "acos(1)", "0"},
                    ExactCase{"atan", "atan(-1)", "-1/4", 1},
                    ExactCase{"atan2_diagonal", "atan2(3 mm, -3 mm)", "3/4", 1},
                    ExactCase{"atan2_below", "atan2(-2, 0)", "-1/2", 1},
                    ExactCase{"atan2_behind", "atan2(0, -2)", "1", 1}),
    name_of_exact);

INSTANTIATE_TEST_SUITE_P(
    Functions,
    ExactValues,
    testing::Values(ExactCase{"sqrt", "sqrt(9/4)", "3/2"},
                    ExactCase{"sqrt_of_an_area", "sqrt(9 mm^2)", "3/1000"},
                    ExactCase{"sqrt_of_a_square_of_pi", "sqrt(4*pi^2)", "2", 1},
                    ExactCase{"abs", "abs(-20 deg)", "1/9", 1},
                    ExactCase{"min", "min(0.1 + 0.2, 0.3, 1)", "3/10"},
                    ExactCase{"max_by_sign", "max(1 rad, -20 deg)", "1"},
                    ExactCase{"floor_of_a_product", "floor(0.29*100)", "29"},
                    ExactCase{"floor", "floor(-3/2)", "-2"},
                    ExactCase{"ceil", "ceil(3/2)", "2"},
                    ExactCase{"round_up", "round(5/2)", "3"},
                    ExactCase{"round_away", "round(-5/2)", "-3"},
                    ExactCase{"mod", "mod(-1, 3)", "2"},
                    ExactCase{"mod_of_angles", "mod(370 deg, 1 rev)", "1/18", 1},
                    ExactCase{"mod_of_decimals", "mod(1, 0.1)", "0"},
                    ExactCase{"gcd", "gcd(12, 18, 8)", "2"},
                    ExactCase{"hypot", "hypot(3 mm, 4 mm)", "1/200"},
                    ExactCase{"exp", "exp(0)", "1"},
                    ExactCase{"ln", "ln(1)", "0"},
                    ExactCase{"log10", "log10(1000)", "3"},
                    ExactCase{"log10_below_one", "log10(0.01)", "-2"}),
    name_of_exact);

struct InexactCase {
  const char* name;
  std::string text;
};

class InexactValues : public testing::TestWithParam<InexactCase> {};

TEST_P(InexactValues, AreThoseOfDouble) {
  const auto result = exactly_evaluated(GetParam().text);

  ASSERT_TRUE(std::holds_alternative<ExactQuantity>(result))
      << std::get<ExpressionError>(result).message;
  EXPECT_FALSE(std::get<ExactQuantity>(result).value.exact.has_value());
}

INSTANTIATE_TEST_SUITE_P(Table,
                         InexactValues,
                         testing::Values(InexactCase{"root", "sqrt(2)"},
                                         InexactCase{"root_of_pi", "sqrt(4*pi)"},
                                         InexactCase{"broken_power", "2^0.5"},
                                         InexactCase{"sine_of_twenty_degrees", "sin(20 deg)"},
                                         InexactCase{"sine_of_forty_five", "sin(45 deg)"},
                                         InexactCase{"sine_of_radians", "sin(0.5 rad)"},
                                         InexactCase{"tangent_of_thirty", "tan(30 deg)"},
                                         InexactCase{"arcsine", "asin(0.3)"},
                                         InexactCase{"arctangent", "atan(2)"},
                                         InexactCase{"degrees_and_radians", "20 deg + 1 rad"},
                                         InexactCase{"pi_and_one", "pi + 1"},
                                         InexactCase{"smaller_of_pi_and_three", "min(pi, 3)"},
                                         InexactCase{"floor_of_pi", "floor(pi)"},
                                         InexactCase{"exponential", "exp(1)"},
                                         InexactCase{"logarithm", "ln(2)"},
                                         InexactCase{"logarithm_of_two_hundred", "log10(200)"},
                                         InexactCase{"hypot_through_a_root", "hypot(2, 3, 6)"},
                                         InexactCase{"parameter_without_exact_value", "root*0 + 1"},
                                         InexactCase{"large_power", "(3/2)^1700*(5/7)^1700"},
                                         InexactCase{"growing_power_of_pi", "(pi^600/2^990)^2"},
                                         InexactCase{"exactly_zero_divisor", "1/ln(1.1*1.1/1.21)"}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Exact, ValueIsThatOfDouble) {
  EXPECT_EQ(std::get<ExactQuantity>(exactly_evaluated("0.1 + 0.2")).value.value, 0.1 + 0.2);
}

TEST(Exact, DimensionIsKept) {
  EXPECT_EQ(std::get<ExactQuantity>(exactly_evaluated("3 mm^2/2")).dimension,
            (Dimension{2, 0, 0, 0}));
}

struct SharedFault {
  const char* name;
  const char* text;
};

class SharedFaults : public testing::TestWithParam<SharedFault> {};

TEST_P(SharedFaults, ReadTheSameAsForDouble) {
  const auto parsed = parse_expression(GetParam().text);
  const auto plain = evaluate(std::get<Expression>(parsed), no_names);

  const auto exact = evaluate<Exact>(std::get<Expression>(parsed), no_names);

  ASSERT_TRUE(std::holds_alternative<ExpressionError>(plain));
  ASSERT_TRUE(std::holds_alternative<ExpressionError>(exact));
  const auto& expected = std::get<ExpressionError>(plain);
  const auto& actual = std::get<ExpressionError>(exact);
  EXPECT_EQ(actual.code, expected.code);
  EXPECT_EQ(actual.offset, expected.offset);
  EXPECT_EQ(actual.length, expected.length);
  EXPECT_EQ(actual.message, expected.message);
  EXPECT_EQ(actual.hint, expected.hint);
}

INSTANTIATE_TEST_SUITE_P(Table,
                         SharedFaults,
                         testing::Values(SharedFault{"dimension", "2 mm + 3"},
                                         SharedFault{"division", "1/(2 - 2)"},
                                         SharedFault{"root", "sqrt(1 - 2)"},
                                         SharedFault{"after_an_inexact_value", "1/(sqrt(2)*0)"},
                                         SharedFault{"overflow", "1e308*1e308"},
                                         SharedFault{"whole_numbers", "gcd(3/2, 2)"},
                                         SharedFault{"unknown_name", "2*dge"},
                                         SharedFault{"divisor_with_a_unit", "1/2 mm + 1 mm"}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Exact, BareNumberTakesTheUnitOfTheFileExactly) {
  FileUnits units;
  units.set(QuantityKind::angle, "deg");
  const auto parsed = parse_expression("30");

  const auto result =
      evaluate_as<Exact>(QuantityKind::angle, std::get<Expression>(parsed), units, no_names);

  EXPECT_EQ(std::get<Exact>(result).exact, (PiRational{Rational(1, 6), 1}));
}

TEST(Exact, LeadPerRadianIsExactPerTurn) {
  const auto parsed = parse_expression("5 mm/rev");

  const auto result =
      evaluate_as<Exact>(QuantityKind::lead, std::get<Expression>(parsed), {}, no_names);

  EXPECT_EQ(std::get<Exact>(result).exact, (PiRational{Rational(1, 200), 0}));
}

TEST(Exact, ParametersStayExactThroughOthers) {
  std::vector<Parameter> list(2);
  list[0] = {"half", std::get<Expression>(parse_expression("tenth*5")), {}};
  list[1] = {"tenth", std::get<Expression>(parse_expression("0.1")), {}};

  const auto values = evaluate_parameters<Exact>(list);

  ASSERT_TRUE(values.errors.empty());
  EXPECT_EQ(values.table.find("half")->value.exact, (PiRational{Rational(1, 2), 0}));
}

}  // namespace
}  // namespace kinestat
