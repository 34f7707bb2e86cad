#include <cmath>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "expression/evaluate.hpp"
#include "expression/parameters.hpp"
#include "math/numbers/exact_input.hpp"

namespace kinestat {
namespace {

using PreciseQuantity = BasicQuantity<ExactInput>;

const PreciseQuantity* no_name(std::string_view /*name*/) {
  return nullptr;
}

PreciseQuantity precisely_evaluated(std::string_view text) {
  return std::get<PreciseQuantity>(
      evaluate<ExactInput>(std::get<Expression>(parse_expression(text)), no_name));
}

struct PreciseCase {
  const char* name;
  std::string text;
  const char* digits;
};

class PreciseValues : public testing::TestWithParam<PreciseCase> {};

TEST_P(PreciseValues, HaveTheDigitsOfTheTables) {
  const ExactInput number = precisely_evaluated(GetParam().text).value;

  ASSERT_TRUE(number.precise.has_value());
  const BigFloat expected(GetParam().digits);
  EXPECT_LE(abs(*number.precise - expected), abs(expected) * BigFloat("1e-48"))
      << number.precise->str();
  EXPECT_NEAR(number.value, static_cast<double>(expected), 1e-15 * std::abs(number.value));
}

// Fifty digits of tabulated constants; sums and units by hand.
INSTANTIATE_TEST_SUITE_P(
    Numbers,
    PreciseValues,
    testing::Values(
        PreciseCase{"typed",
                    "0.1234567890123456789012345678901234567890",
                    "0.1234567890123456789012345678901234567890"},
        PreciseCase{"exponent", "-12.5e-40", "-1.25e-39"},
        PreciseCase{"unit", "1.1 mm", "0.0011"},
        PreciseCase{"quotient", "1/7", "0.14285714285714285714285714285714285714285714285714"},
        PreciseCase{"pi", "pi", "3.1415926535897932384626433832795028841971693993751"},
        PreciseCase{"degree", "1 deg", "0.017453292519943295769236907684886127134428718885417"},
        PreciseCase{"root", "sqrt(2)", "1.4142135623730950488016887242096980785696718753769"},
        PreciseCase{
            "length_of_two", "hypot(1, 1)", "1.4142135623730950488016887242096980785696718753769"},
        PreciseCase{"broken_power", "2^0.5", "1.4142135623730950488016887242096980785696718753769"},
        PreciseCase{"whole_power", "(-3)^3", "-27"},
        PreciseCase{"negative_power", "2^(-3)", "0.125"},
        PreciseCase{"e", "exp(1)", "2.7182818284590452353602874713526624977572470937000"},
        PreciseCase{"logarithm", "ln(2)", "0.69314718055994530941723212145817656807550013436026"},
        PreciseCase{"decimal_logarithm",
                    "log10(2)",
                    "0.30102999566398119521373889472449302676818988146211"},
        PreciseCase{"sine", "sin(60 deg)", "0.86602540378443864676372317075293618347140262690519"},
        PreciseCase{
            "cosine", "cos(45 deg)", "0.70710678118654752440084436210484903928483593768847"},
        PreciseCase{
            "tangent", "tan(60 deg)", "1.7320508075688772935274463415058723669428052538104"},
        PreciseCase{"arcsine", "asin(1)", "1.5707963267948966192313216916397514420985846996876"},
        PreciseCase{
            "arccosine", "acos(0.5)", "1.0471975511965977461542144610931676280657231331250"},
        PreciseCase{
            "arctangent", "atan(1)", "0.78539816339744830961566084581987572104929234984378"},
        PreciseCase{"angle_of_vector",
                    "atan2(-1, -1)",
                    "-2.3561944901923449288469825374596271631478770495313"},
        PreciseCase{"rest", "mod(-0.1, 0.3)", "0.2"},
        PreciseCase{"rounded", "round(-2.5)", "-3"},
        PreciseCase{"floor", "floor(-2.1)", "-3"},
        PreciseCase{"ceiling", "ceil(2.1)", "3"},
        PreciseCase{"magnitude", "abs(-0.1)", "0.1"},
        PreciseCase{"divisor", "gcd(12, 18)", "6"},
        PreciseCase{"extremes", "max(0.1, min(0.3, 0.2))", "0.2"}),
    [](const auto& one) { return one.param.name; });

class DecimalsAsTyped : public testing::TestWithParam<PreciseCase> {};

// 1.1*1.1 is 1.21, of decimals; of binary fractions, of doubles too, it is not.
TEST_P(DecimalsAsTyped, AreExact) {
  const ExactInput number = precisely_evaluated(GetParam().text).value;

  ASSERT_TRUE(number.precise.has_value());
  EXPECT_EQ(*number.precise, BigFloat(GetParam().digits)) << number.precise->str();
}

INSTANTIATE_TEST_SUITE_P(
    Numbers,
    DecimalsAsTyped,
    testing::Values(PreciseCase{"no_rest", "mod(1.1*1.1, 1.21)", "0"},
                    PreciseCase{"whole_quotient", "floor(1.21/(1.1*1.1))", "1"},
                    PreciseCase{"whole_from_below", "ceil(1.1*1.1/1.21)", "1"},
                    PreciseCase{"half", "round(1.21/(1.1*1.1)/2)", "1"},
                    PreciseCase{"after_cancelling", "floor((1000.000000001 - 1000)/1e-9)", "1"},
                    PreciseCase{"under_a_root", "sqrt(1.21) - 1.1", "0"},
                    // Powers that are no fractions to the program.
                    PreciseCase{"floor_of_a_power", "floor(0.001^(1/3)*100)", "10"},
                    PreciseCase{"rest_of_a_power", "mod(0.001^(1/3), 0.1)", "0"},
                    PreciseCase{"half_of_a_power", "round(1000^(1/3)/4)", "3"}),
    [](const auto& one) { return one.param.name; });

// A product with a minus zero is no angle of -180 deg.
TEST(Precise, IsBehindHalfATurnAtItsPositiveEnd) {
  const ExactInput angle = precisely_evaluated("atan2(-0*exp(1), -1)").value;

  EXPECT_GT(*angle.precise, 3);
}

TEST(Precise, HasAHundredDigits) {
  const ExactInput third = precisely_evaluated("1/3").value;

  EXPECT_LT(abs(3 * *third.precise - 1), BigFloat("1e-99"));
}

// Of a hundred digits typed the last counts.
TEST(Precise, KeepsADifferenceInTheLastDigit) {
  const std::string zeros(98, '0');

  const ExactInput last = precisely_evaluated("1." + zeros + "1 - 1").value;

  EXPECT_EQ(last.precise->convert_to<double>(), 1e-99);
}

// Doubles divide by a rounding error of 2.2e-16 here.
TEST(Precise, IsEmptyWhereOnlyRoundingGivesAValue) {
  EXPECT_FALSE(precisely_evaluated("1/ln(1.1*1.1/1.21)").value.precise.has_value());
}

TEST(Precise, FollowsThroughParameters) {
  const std::vector<Parameter> parameters = {
      {"third", std::get<Expression>(parse_expression("1/3")), {}},
      {"whole", std::get<Expression>(parse_expression("3*third")), {}}};

  const auto values = evaluate_parameters<ExactInput>(parameters);

  EXPECT_LT(abs(*values.table.find("whole")->value.precise - 1), BigFloat("1e-99"));
}

TEST(Precise, CountsInTheUnitsOfTheFile) {
  FileUnits units;
  units.set(QuantityKind::angle, "deg");

  const auto angle = evaluate_as<ExactInput>(
      QuantityKind::angle, std::get<Expression>(parse_expression("180")), units, no_name);

  EXPECT_LT(abs(*std::get<ExactInput>(angle).precise -
                BigFloat("3.1415926535897932384626433832795028841971693993751")),
            BigFloat("1e-48"));
}

}  // namespace
}  // namespace kinestat
