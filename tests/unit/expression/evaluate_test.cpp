#include "expression/evaluate.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "support/angles.hpp"

namespace kinestat {
namespace {

constexpr Dimension kBare{};
constexpr Dimension kLength{1, 0, 0, 0};
constexpr Dimension kAngle{0, 0, 0, 1};

const Quantity* lookup(std::string_view name) {
  static const Quantity teeth{24.0, {}};
  static const Quantity crank{0.05, kLength};
  static const Quantity alpha{kPi / 9, kAngle};
  return name == "N1" ? &teeth : name == "crank" ? &crank : name == "alpha" ? &alpha : nullptr;
}

std::variant<Quantity, ExpressionError> evaluated(std::string_view text) {
  static const std::vector<std::string> known = {"N1", "crank", "alpha"};
  auto parsed = parse_expression(text);
  if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
    return *error;
  }
  return evaluate(std::get<Expression>(parsed), lookup, known);
}

struct ValueCase {
  const char* name;
  const char* text;
  double value;
  Dimension dimension;
};

class Values : public testing::TestWithParam<ValueCase> {};

TEST_P(Values, AreWhatTheTextMeans) {
  const auto result = evaluated(GetParam().text);

  ASSERT_TRUE(std::holds_alternative<Quantity>(result))
      << std::get<ExpressionError>(result).message;
  EXPECT_DOUBLE_EQ(std::get<Quantity>(result).value, GetParam().value);
  EXPECT_EQ(std::get<Quantity>(result).dimension, GetParam().dimension);
}

std::string name_of_value(const testing::TestParamInfo<ValueCase>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Numbers,
                         Values,
                         testing::Values(ValueCase{"integer", "12", 12, kBare},
                                         ValueCase{"decimal", "12.5", 12.5, kBare},
                                         ValueCase{"point_first", ".5", 0.5, kBare},
                                         ValueCase{"point_last", "12.", 12, kBare},
                                         ValueCase{"exponent", "1e-3", 1e-3, kBare},
                                         ValueCase{"capital_exponent", "2.5E+3", 2500, kBare},
                                         ValueCase{"exponent_after_point", "1.e3", 1000, kBare},
                                         ValueCase{"plus", "+3", 3, kBare},
                                         ValueCase{"minus", "-3", -3, kBare},
                                         ValueCase{"zero_with_decimals", "0.50", 0.5, kBare},
                                         ValueCase{"smallest_subnormal", "5e-324", 5e-324, kBare},
                                         ValueCase{"zero_with_exponent", "0e999", 0, kBare},
                                         ValueCase{"blanks_around", "  7\n", 7, kBare}),
                         name_of_value);

INSTANTIATE_TEST_SUITE_P(Precedence,
                         Values,
                         testing::Values(ValueCase{"product_before_sum", "2 + 3*4", 14, kBare},
                                         ValueCase{
                                             "difference_groups_left", "10 - 4 - 3", 3, kBare},
                                         ValueCase{"quotient_groups_left", "24/4/2", 3, kBare},
                                         ValueCase{"power_groups_right", "2^3^2", 512, kBare},
                                         ValueCase{"minus_after_power", "-2^2", -4, kBare},
                                         ValueCase{"negative_exponent", "2^-1", 0.5, kBare},
                                         ValueCase{"signs", "2 - -3 - +1", 4, kBare},
                                         ValueCase{"sign_of_factor", "2*-3", -6, kBare},
                                         ValueCase{"parentheses", "(2 + 3)*4", 20, kBare},
                                         ValueCase{"parameters", "(N1 + 6)/2", 15, kBare},
                                         ValueCase{"pi", "2*pi", 2 * kPi, kBare}),
                         name_of_value);

INSTANTIATE_TEST_SUITE_P(
    Measures,
    Values,
    testing::Values(ValueCase{"degrees", "20 deg", kPi / 9, kAngle},
                    ValueCase{"no_blank", "2.5mm", 2.5e-3, kLength},
                    ValueCase{"moment", "5 N*m", 5, {2, 1, -2, 0}},
                    ValueCase{"moment_in_millimetres", "5 N*mm", 5e-3, {2, 1, -2, 0}},
                    ValueCase{"speed", "1 rad/s", 1, {0, 0, -1, 1}},
                    ValueCase{"half_an_angle", "6 deg/2", kPi / 60, kAngle},
                    ValueCase{"stiffness", "3 N/mm", 3000, {0, 1, -2, 0}},
                    ValueCase{"square_of_the_unit", "2 mm^2", 2e-6, {2, 0, 0, 0}},
                    ValueCase{"acceleration", "9.81 m/s^2", 9.81, {1, 0, -2, 0}},
                    ValueCase{"negative_power", "3 s^-1", 3, {0, 0, -1, 0}},
                    ValueCase{"unit_binds_closest", "1/2 mm", 500, {-1, 0, 0, 0}},
                    ValueCase{"ratio_of_measures", "10 mm/2 mm", 5, kBare},
                    ValueCase{"negative_measure", "-2 mm", -2e-3, kLength},
                    ValueCase{"parameter_and_measure", "N1*2 mm", 0.048, kLength},
                    ValueCase{"fraction_of_a_unit", "(1/2) mm", 5e-4, kLength},
                    ValueCase{"fraction_of_a_moment", "-13/27*(1 N*m)", -13.0 / 27, {2, 1, -2, 0}},
                    ValueCase{"grouped_moment", "(-13/27) N*m", -13.0 / 27, {2, 1, -2, 0}},
                    ValueCase{"grouped_square", "(3) mm^2", 3e-6, {2, 0, 0, 0}},
                    ValueCase{"group_binds_closest", "1/(2) mm", 500, {-1, 0, 0, 0}},
                    ValueCase{"power_of_a_group", "(2)^2*mm", 4e-3, kLength},
                    ValueCase{"unit_as_factor", "5*mm", 5e-3, kLength},
                    ValueCase{"unit_first", "mm*5", 5e-3, kLength},
                    ValueCase{"sum_of_units", "3 mm + 2 cm", 0.023, kLength},
                    ValueCase{"multiple_of_zero", "0*1e-300*1e-300", 0, kBare},
                    ValueCase{"power_of_zero", "0^1000", 0, kBare},
                    ValueCase{"zero_of_a_unit", "0 um", 0, kLength},
                    ValueCase{"minutes", "5 min", 300, {0, 0, 1, 0}},
                    ValueCase{"minutes_beside_the_minimum", "min(2 min, 1 h)", 120, {0, 0, 1, 0}},
                    ValueCase{
                        "power_of_speed_and_moment", "10 Nm*30 rpm", 10 * kPi, {2, 1, -3, 1}}),
    name_of_value);

INSTANTIATE_TEST_SUITE_P(
    FunctionValues,
    Values,
    testing::Values(ValueCase{"sin", "sin(30 deg)", std::sin(kPi / 6), kBare},
                    ValueCase{"cos", "cos(alpha)", std::cos(kPi / 9), kBare},
                    ValueCase{"tan", "tan(45 deg)", std::tan(kPi / 4), kBare},
                    ValueCase{"sin_of_half_a_turn", "sin(180 deg)", 0, kBare},
                    ValueCase{"sin_of_a_turn", "sin(-2*pi*1 rad)", 0, kBare},
                    ValueCase{"cos_of_a_right_angle", "cos(90 deg)", 0, kBare},
                    ValueCase{"cos_of_three", "cos(360 deg - 90 deg)", 0, kBare},
                    ValueCase{"cos_of_a_sum", "cos(33.3 deg + 56.7 deg)", 0, kBare},
                    ValueCase{"cos_of_many_turns", "cos(1000.25 rev)", 0, kBare},
                    ValueCase{"tan_of_half_a_turn", "tan(180 deg)", 0, kBare},
                    ValueCase{"sin_of_fifteen_digits",
                              "sin(180.000000000001 deg)",
                              std::sin(180.000000000001 / 180 * kPi),
                              kBare},
                    ValueCase{"cos_of_fifteen_digits",
                              "cos(89.9999999999999 deg)",
                              std::cos(89.9999999999999 / 180 * kPi),
                              kBare},
                    ValueCase{"sin_of_a_small_angle", "sin(1e-30 rad)", 1e-30, kBare},
                    ValueCase{"tan_near_a_pole", "tan(89 deg)", std::tan(89 * kPi / 180), kBare},
                    ValueCase{"tan_where_cos_is_not_zero",
                              "tan(89.9999999999999 deg)",
                              std::tan(89.9999999999999 / 180 * kPi),
                              kBare},
                    ValueCase{"asin", "asin(0.5)", kPi / 6, kAngle},
                    ValueCase{"acos", "acos(0.5)", kPi / 3, kAngle},
                    ValueCase{"atan", "atan(1)", kPi / 4, kAngle},
                    ValueCase{"atan2_of_lengths", "atan2(3 mm, -3 mm)", 3 * kPi / 4, kAngle},
                    ValueCase{"atan2_of_minus_zero", "atan2(-2*0, -1)", kPi, kAngle},
                    ValueCase{"sqrt_of_an_area", "sqrt(9 mm^2)", 3e-3, kLength},
                    ValueCase{"abs", "abs(-3 mm)", 3e-3, kLength},
                    ValueCase{"exp", "exp(1)", std::numbers::e, kBare},
                    ValueCase{"log_is_natural", "log(exp(2))", 2, kBare},
                    ValueCase{"ln", "ln(exp(2))", 2, kBare},
                    ValueCase{"log10", "log10(1000)", 3, kBare},
                    ValueCase{"min_of_three", "min(3, 1, 2)", 1, kBare},
                    ValueCase{"max_of_lengths", "max(3 mm, 1 cm)", 0.01, kLength},
                    ValueCase{"floor", "floor(-1.5)", -2, kBare},
                    ValueCase{"ceil", "ceil(1.2)", 2, kBare},
                    ValueCase{"round_half_away", "round(-2.5)", -3, kBare},
                    ValueCase{"mod_has_the_sign_of_the_divisor", "mod(-1, 3)", 2, kBare},
                    ValueCase{"mod_but_for_rounding", "mod(0.3, 0.1)", 0, kBare},
                    ValueCase{"mod_of_many", "mod(9007199254740991, 2)", 1, kBare},
                    ValueCase{"floor_but_for_rounding", "floor(0.3/0.1)", 3, kBare},
                    ValueCase{"ceil_but_for_rounding", "ceil(0.1*3/0.1)", 3, kBare},
                    ValueCase{"round_but_for_rounding", "round(0.15/0.1)", 2, kBare},
                    ValueCase{"floor_below_a_whole", "floor(2.99999999)", 2, kBare},
                    ValueCase{"mod_of_angles", "mod(7 rad, 2 rad)", 1, kAngle},
                    ValueCase{"gcd_of_many", "gcd(9007199254740991, 6361)", 6361, kBare},
                    ValueCase{"gcd_of_three", "gcd(12, 18, 8)", 2, kBare},
                    ValueCase{"hypot", "hypot(3 mm, 4 mm)", 5e-3, kLength},
                    ValueCase{"hypot_of_three", "hypot(2, 3, 6)", 7, kBare}),
    name_of_value);

struct EvaluationFault {
  const char* name;
  const char* text;
  int offset;
  int length;
  const char* code;
  const char* message;
  const char* hint;
};

class EvaluationFaults : public testing::TestWithParam<EvaluationFault> {};

TEST_P(EvaluationFaults, AreNamedAtTheirPlace) {
  const auto result = evaluated(GetParam().text);

  ASSERT_TRUE(std::holds_alternative<ExpressionError>(result));
  const auto& error = std::get<ExpressionError>(result);
  EXPECT_EQ(error.offset, GetParam().offset);
  EXPECT_EQ(error.length, GetParam().length);
  EXPECT_EQ(error.code, GetParam().code);
  EXPECT_NE(error.message.find(GetParam().message), std::string::npos) << error.message;
  EXPECT_NE(error.hint.find(GetParam().hint), std::string::npos) << error.hint;
}

std::string name_of_fault(const testing::TestParamInfo<EvaluationFault>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Dimensions,
    EvaluationFaults,
    testing::Values(
        EvaluationFault{"sum",
                        "20 deg + 3 mm",
                        0,
                        13,
                        "E0309",
                        "an angle and a length cannot be added",
                        "measure the same"},
        EvaluationFault{"difference",
                        "2*(crank - 3)",
                        3,
                        9,
                        "E0309",
                        "a length and a bare number cannot be subtracted",
                        "write a unit"},
        EvaluationFault{"fraction_before_a_unit",
                        "crank + 1/2 mm - 3/4 cm",
                        0,
                        14,
                        "E0309",
                        "a length and a quantity in 1/m cannot be added",
                        "write crank + (1/2) mm - (3/4) cm"},
        EvaluationFault{"sine_of_a_bare_number",
                        "1 + sin(30)",
                        8,
                        2,
                        "E0309",
                        "'sin' takes an angle, not a bare number",
                        "write 30 deg or 0.52 rad"},
        EvaluationFault{
            "exponential", "exp(2 mm)", 4, 4, "E0309", "a bare number, not a length", ""},
        EvaluationFault{"maximum", "max(1 mm, 2)", 0, 12, "E0309", "a length and a bare", "unit"},
        EvaluationFault{"root", "sqrt(4 mm)", 5, 4, "E0309", "a length has no square root", ""},
        EvaluationFault{"exponent", "2^(3 mm)", 3, 4, "E0309", "not a length", "without a unit"},
        EvaluationFault{"broken_power", "crank^0.5", 6, 3, "E0309", "whole power", "sqrt"},
        EvaluationFault{"huge_power", "crank^1e9", 6, 3, "E0309", "small whole power", ""},
        EvaluationFault{
            "powers_of_powers", "((1 m)^900)^900", 0, 15, "E0309", "beyond any use", "powers"},
        EvaluationFault{
            "divisor_of_lengths", "gcd(1 mm, 2 mm)", 0, 15, "E0309", "whole numbers", ""}),
    name_of_fault);

INSTANTIATE_TEST_SUITE_P(
    NoValue,
    EvaluationFaults,
    testing::Values(
        EvaluationFault{"division", "1/0", 2, 1, "E0316", "division by zero", "divisor"},
        EvaluationFault{"difference", "1/(N1 - 24)", 3, 7, "E0316", "division by zero", ""},
        EvaluationFault{"root", "sqrt(-1)", 5, 2, "E0316", "'sqrt' of -1", "not be negative"},
        EvaluationFault{"logarithm", "ln(0)", 3, 1, "E0316", "'ln' of 0", "greater than zero"},
        EvaluationFault{"arcsine", "asin(2)", 5, 1, "E0316", "'asin' of 2", "-1 to 1"},
        EvaluationFault{"zero_power", "0^-1", 0, 1, "E0316", "division by zero", ""},
        EvaluationFault{
            "broken_power", "(-8)^(1/3)", 1, 2, "E0316", "no fractional power", "whole"},
        EvaluationFault{"remainder", "mod(3, 0)", 7, 1, "E0316", "division by zero", ""},
        EvaluationFault{"remainder_of_rounded",
                        "mod(9007199254740993, 3)",
                        4,
                        16,
                        "E0316",
                        "no sure answer: from 2^53 on whole numbers are rounded",
                        "9007199254740992"},
        EvaluationFault{"remainder_by_rounded", "mod(1, 1e20)", 7, 4, "E0316", "rounded", ""},
        EvaluationFault{"remainder_far_beyond",
                        "mod(1e17 rad, 3.5 rad)",
                        4,
                        8,
                        "E0316",
                        "2^53 times the second",
                        "lost in the rounding"},
        EvaluationFault{
            "divisor_of_rounded", "gcd(9007199254740993, 3)", 4, 16, "E0316", "rounded", ""},
        EvaluationFault{"divisor_of_many", "gcd(15, 1e20)", 8, 4, "E0316", "1e+20", "below"},
        EvaluationFault{"divisor", "gcd(1.5, 2)", 0, 11, "E0316", "whole numbers", "teeth"},
        EvaluationFault{"overflow", "2*1e308*10", 0, 7, "E0316", "not finite", ""},
        EvaluationFault{"overflow_in_si", "1e308 kW", 0, 8, "E0316", "not finite", ""},
        EvaluationFault{"underflow", "1e-200*1e-200", 0, 13, "E0316", "too small", "write 0"},
        EvaluationFault{"underflow_of_a_quotient", "1e-200/1e200", 0, 12, "E0316", "too small", ""},
        EvaluationFault{"underflow_of_a_power", "2^-100000", 0, 9, "E0316", "too small", ""},
        EvaluationFault{"underflow_of_exp", "exp(-1000)", 0, 10, "E0316", "too small", ""},
        EvaluationFault{"underflow_in_si", "1e-322 mm", 0, 9, "E0316", "too small", ""},
        EvaluationFault{"underflow_by_a_unit", "1e-322 / kW", 0, 11, "E0316", "too small", ""},
        EvaluationFault{"pole", "1 + tan(90 deg)", 8, 6, "E0316", "'tan' of an odd", "angle"},
        EvaluationFault{"pole_of_three", "tan(-270 deg)", 4, 8, "E0316", "'tan' of an odd", ""},
        EvaluationFault{"pole_in_radians", "tan(7*pi/2*1 rad)", 4, 12, "E0316", "'tan'", ""},
        EvaluationFault{"pole_in_turns", "tan(1000.25 rev)", 4, 11, "E0316", "'tan'", ""},
        EvaluationFault{"pole_of_a_sum", "tan(33.3 deg + 56.7 deg)", 4, 19, "E0316", "'tan'", ""}),
    name_of_fault);

INSTANTIATE_TEST_SUITE_P(
    Names,
    EvaluationFaults,
    testing::Values(
        EvaluationFault{"near_a_parameter", "2*N9", 2, 2, "E0311", "unknown name 'N9'", "'N1'"},
        EvaluationFault{"near_a_unit", "3*dge", 2, 3, "E0311", "unknown name 'dge'", "'deg'"},
        EvaluationFault{"capitals", "3*MM", 2, 2, "E0311", "unknown name 'MM'", "'mm'"},
        EvaluationFault{"capital_pi", "2*PI", 2, 2, "E0311", "unknown name 'PI'", "'pi'"},
        EvaluationFault{
            "infinity", "2*Inf", 2, 3, "E0308", "'Inf' is not a finite", "finite number"},
        EvaluationFault{
            "no_number", "nan", 0, 3, "E0308", "'nan' is not a finite", "finite number"}),
    name_of_fault);

TEST(Evaluate, NegationOfZeroHasNoSign) {
  const auto result = evaluated("-(1 - 1)");

  EXPECT_FALSE(std::signbit(std::get<Quantity>(result).value));
}

// Of the decimals as typed each of these is zero; of the doubles none is.
TEST(Evaluate, SumIsZeroWhereItIsMereRounding) {
  for (const char* text : {"0.1 + 0.2 - 0.3",
                           "0.3 - 0.1 - 0.2",
                           "-0.3 + (0.1 + 0.2)",
                           "100.1 - 100 - 0.1",
                           "1e10 + 0.1 - 1e10 - 0.1",
                           "(100.1 - 100)*1 mm - 0.1 mm",
                           "(0.7 - 0.6)/3 - 0.1/3",
                           "50*sqrt(2) - 100*sin(45 deg)"}) {
    const auto result = evaluated(text);
    EXPECT_EQ(std::get<Quantity>(result).value, 0.0) << text;
    EXPECT_FALSE(std::signbit(std::get<Quantity>(result).value)) << text;
  }
  const auto divided = evaluated("1/(0.1 + 0.2 - 0.3)");
  EXPECT_EQ(std::get<ExpressionError>(divided).code, "E0316");
}

// What is typed differs by more than decimals are rounded.
TEST(Evaluate, SumKeepsWhatIsTyped) {
  EXPECT_EQ(std::get<Quantity>(evaluated("1 - 0.9999999999999998")).value, 0x1p-52);
  EXPECT_EQ(std::get<Quantity>(evaluated("9007199254740991 - 9007199254740990")).value, 1.0);
  EXPECT_EQ(std::get<Quantity>(evaluated("1e-20 - 2e-20")).value, -1e-20);
  EXPECT_NEAR(std::get<Quantity>(evaluated("100.1 - 100 - 0.1000000000001")).value, -1e-13, 2e-14);
}

TEST(Evaluate, MeasureIsTheDoubleNearestToItsDecimal) {
  EXPECT_EQ(std::get<Quantity>(evaluated("6 mm")).value, 0.006);
}

TEST(Evaluate, PlaceWithoutParametersKnowsNoNames) {
  const auto parsed = parse_expression("N1");

  const auto result = evaluate(std::get<Expression>(parsed), no_names);

  EXPECT_EQ(std::get<ExpressionError>(result).code, "E0311");
}

FileUnits millimetres_and_degrees() {
  FileUnits units;
  units.set(QuantityKind::length, "mm");
  units.set(QuantityKind::angle, "deg");
  return units;
}

struct PlaceCase {
  const char* name;
  const char* text;
  QuantityKind kind;
  double value;
};

class Places : public testing::TestWithParam<PlaceCase> {};

TEST_P(Places, GiveTheValueInSi) {
  const auto parsed = parse_expression(GetParam().text);

  const auto result =
      evaluate_as(GetParam().kind, std::get<Expression>(parsed), millimetres_and_degrees(), lookup);

  ASSERT_TRUE(std::holds_alternative<double>(result)) << std::get<ExpressionError>(result).message;
  EXPECT_DOUBLE_EQ(std::get<double>(result), GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(
    Table,
    Places,
    testing::Values(PlaceCase{"bare_length", "7", QuantityKind::length, 0.007},
                    PlaceCase{"bare_angle", "180", QuantityKind::angle, kPi},
                    PlaceCase{"bare_velocity", "20", QuantityKind::velocity, 0.02},
                    PlaceCase{"bare_angular_velocity", "3", QuantityKind::angular_velocity, 3},
                    PlaceCase{"bare_number", "N1", QuantityKind::dimensionless, 24},
                    PlaceCase{"measured_length", "2 cm", QuantityKind::length, 0.02},
                    PlaceCase{"arc", "180 deg*5 mm", QuantityKind::length, 0.005 * kPi},
                    PlaceCase{"moment_per_radian", "3 N*m/rad", QuantityKind::moment, 3},
                    PlaceCase{"pitch_per_turn", "5 mm/rev", QuantityKind::pitch, 0.005 / (2 * kPi)},
                    PlaceCase{"pitch_as_length", "2 mm", QuantityKind::pitch, 0.002},
                    PlaceCase{"bare_pitch", "2", QuantityKind::pitch, 0.002},
                    PlaceCase{"lead_as_length", "5 mm", QuantityKind::lead, 0.005},
                    PlaceCase{"lead_per_turn", "5 mm/rev", QuantityKind::lead, 0.005},
                    PlaceCase{"bare_lead", "5", QuantityKind::lead, 0.005}),
    [](const auto& row) { return std::string(row.param.name); });

struct MisfitCase {
  const char* name;
  const char* text;
  QuantityKind kind;
  const char* message;
  const char* hint;
};

class Misfits : public testing::TestWithParam<MisfitCase> {};

TEST_P(Misfits, NameBothDimensions) {
  const auto parsed = parse_expression(GetParam().text);

  const auto result = evaluate_as(GetParam().kind, std::get<Expression>(parsed), {}, lookup);

  ASSERT_TRUE(std::holds_alternative<ExpressionError>(result));
  const auto& error = std::get<ExpressionError>(result);
  EXPECT_EQ(error.code, "E0309");
  EXPECT_EQ(error.message, GetParam().message);
  EXPECT_EQ(error.hint, GetParam().hint);
  EXPECT_EQ(error.length, static_cast<int>(std::string_view(GetParam().text).size()));
}

INSTANTIATE_TEST_SUITE_P(
    Table,
    Misfits,
    testing::Values(MisfitCase{"length_for_angle",
                               "2 mm",
                               QuantityKind::angle,
                               "expected an angle, found a length",
                               "write 2 deg or 2 rad"},
                    MisfitCase{"frequency_for_speed",
                               "3/(2 s)",
                               QuantityKind::angular_velocity,
                               "expected an angular velocity, found a quantity in 1/s",
                               "write 1 rad/s or 1500 rpm"},
                    MisfitCase{"angle_for_number",
                               "20 deg",
                               QuantityKind::dimensionless,
                               "expected a bare number, found an angle",
                               "write the number without a unit"},
                    MisfitCase{"fraction_before_a_unit",
                               "-13/27 N*m",
                               QuantityKind::moment,
                               "expected a moment, found a quantity in s^2/kg",
                               "a unit belongs to the number right before it: write (-13/27) N*m"},
                    MisfitCase{"named_fraction_before_a_unit",
                               "2*N1/9 mm",
                               QuantityKind::length,
                               "expected a length, found a quantity in 1/m",
                               "a unit belongs to the number right before it: write (2*N1/9) mm"},
                    MisfitCase{"fraction_that_does_not_help",
                               "1/2 mm",
                               QuantityKind::angle,
                               "expected an angle, found a quantity in 1/m",
                               "write 30 deg or 0.52 rad"},
                    MisfitCase{"grouped_divisor",
                               "1/(2 mm)",
                               QuantityKind::length,
                               "expected a length, found a quantity in 1/m",
                               "write 5 mm or 0.005 m"},
                    MisfitCase{"force_for_moment",
                               "5 N",
                               QuantityKind::moment,
                               "expected a moment, found a force",
                               "write 5 N*m or 5 N*mm"}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(Fit, NumberThatTheUnitMakesInfiniteHasNoValue) {
  FileUnits units;
  units.set(QuantityKind::length, "km");

  const auto result = fit({1e308, {}}, QuantityKind::length, units);

  EXPECT_EQ(std::get<ExpressionError>(result).code, "E0316");
}

TEST(Fit, NumberThatTheUnitMakesZeroHasNoValue) {
  FileUnits units;
  units.set(QuantityKind::length, "um");

  const auto result = fit({1e-320, {}}, QuantityKind::length, units);

  EXPECT_EQ(std::get<ExpressionError>(result).code, "E0316");
  EXPECT_TRUE(std::holds_alternative<double>(fit({0.0, {}}, QuantityKind::length, units)));
}

}  // namespace
}  // namespace kinestat
