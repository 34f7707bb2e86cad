#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "expression/evaluate.hpp"
#include "expression/parameters.hpp"
#include "math/numbers/dual.hpp"
#include "support/angles.hpp"

namespace kinestat {
namespace {

using DualQuantity = BasicQuantity<Dual>;

constexpr double kTight = 1e-14;

// x = 3, y = 4 m.
const DualQuantity* variable_named(std::string_view name) {
  static const DualQuantity x{make_variable(3.0, 0, 2), {}};
  static const DualQuantity y{make_variable(4.0, 1, 2), {1, 0, 0, 0}};
  return name == "x" ? &x : name == "y" ? &y : nullptr;
}

DualQuantity with_derivatives(std::string_view text) {
  const auto parsed = parse_expression(text);
  auto result = evaluate<Dual>(std::get<Expression>(parsed), variable_named);
  if (const auto* error = std::get_if<ExpressionError>(&result)) {
    ADD_FAILURE() << text << ": " << error->message;
    return {};
  }
  return std::get<DualQuantity>(std::move(result));
}

struct DerivativeCase {
  const char* name;
  const char* text;
  double by_x;
  double by_y;
};

class Derivatives : public testing::TestWithParam<DerivativeCase> {};

TEST_P(Derivatives, AreThoseOfTheTextbook) {
  const Dual number = with_derivatives(GetParam().text).value;

  EXPECT_NEAR(derivative(number, 0), GetParam().by_x, kTight);
  EXPECT_NEAR(derivative(number, 1), GetParam().by_y, kTight);
}

TEST(DualExpression, HasNoSlopeWhereASineTurns) {
  EXPECT_EQ(derivative(with_derivatives("sin(x*30 deg)").value, 0), 0.0);
  EXPECT_EQ(derivative(with_derivatives("cos(x*60 deg)").value, 0), 0.0);
}

// By hand, at x = 3 and y = 4 m.
INSTANTIATE_TEST_SUITE_P(
    Table,
    Derivatives,
    testing::Values(DerivativeCase{"constant", "2 mm + 1 in", 0, 0},
                    DerivativeCase{"pi", "pi*x", kPi, 0},
                    DerivativeCase{"sum", "2*x - x + 1", 1, 0},
                    DerivativeCase{"product", "x*y", 4, 3},
                    DerivativeCase{"quotient", "y/x", -4.0 / 9, 1.0 / 3},
                    DerivativeCase{"negation", "-y", 0, -1},
                    DerivativeCase{"unit_as_factor", "x*mm", 1e-3, 0},
                    DerivativeCase{"unit_as_divisor", "y/mm", 0, 1000},
                    DerivativeCase{"unit_of_a_group", "(2*x) cm", 0.02, 0},
                    DerivativeCase{"power", "x^3", 27, 0},
                    DerivativeCase{"power_with_variable_exponent", "2^x", 8 * std::log(2), 0},
                    DerivativeCase{
                        "sine_of_degrees", "sin(x*10 deg)", kPi / 18 * std::cos(kPi / 6), 0},
                    DerivativeCase{"cosine_that_is_zero", "cos(x*30 deg)", -kPi / 6, 0},
                    DerivativeCase{"sine_that_is_zero", "sin(x*60 deg)", -kPi / 3, 0},
                    DerivativeCase{"tangent", "tan(x*15 deg)", kPi / 6, 0},
                    DerivativeCase{"arcsine", "asin(x/5)", 0.25, 0},
                    DerivativeCase{"angle", "atan2(y, x*1 m)", -0.16, 0.12},
                    DerivativeCase{"root", "sqrt(y*4 m)", 0, 0.5},
                    DerivativeCase{"exponential", "exp(x - 3)", 1, 0},
                    DerivativeCase{"logarithm", "ln(x)", 1.0 / 3, 0},
                    DerivativeCase{"decimal_logarithm", "log10(x)", 1 / (3 * std::log(10)), 0},
                    DerivativeCase{"hypotenuse", "hypot(x*1 m, y)", 0.6, 0.8},
                    DerivativeCase{"minimum", "min(x*1 m, y)", 1, 0},
                    DerivativeCase{"maximum", "max(x*1 m, y)", 0, 1},
                    DerivativeCase{"remainder", "mod(20, x)", -6, 0},
                    DerivativeCase{"remainder_of_the_variable", "mod(y, 3 m)", 0, 1}),
    [](const auto& row) { return std::string(row.param.name); });

INSTANTIATE_TEST_SUITE_P(
    BetweenKinks,
    Derivatives,
    testing::Values(DerivativeCase{"floor", "floor(x + 0.25)", 0, 0},
                    DerivativeCase{"ceil", "ceil(x + 0.5)", 0, 0},
                    DerivativeCase{"round", "round(x)", 0, 0},
                    DerivativeCase{"gcd_of_constants", "x*gcd(4, 6)", 2, 0},
                    DerivativeCase{"corner_of_a_constant", "x*abs(3 - 3) + hypot(0, 0)", 0, 0},
                    DerivativeCase{"jump_of_a_constant", "x*floor(3)", 3, 0},
                    DerivativeCase{"both_sides_move_alike", "max(x, 2*x - 3 + 0*x - x + 3)", 1, 0}),
    [](const auto& row) { return std::string(row.param.name); });

class Corners : public testing::TestWithParam<DerivativeCase> {};

// By the text, the slope on the left and that on the right differ, or the value jumps.
TEST_P(Corners, LeaveNoDerivativeButThatOfOtherVariables) {
  const Dual number = with_derivatives(GetParam().text).value;

  EXPECT_TRUE(std::isnan(derivative(number, 0)));
  EXPECT_EQ(derivative(number, 1), GetParam().by_y);
}

INSTANTIATE_TEST_SUITE_P(Table,
                         Corners,
                         testing::Values(DerivativeCase{"abs", "y + abs(x - 3)*1 m", 0, 1},
                                         DerivativeCase{"min", "y + min(x, 3)*1 m", 0, 1},
                                         DerivativeCase{"max", "max(x, 3, 2)", 0, 0},
                                         DerivativeCase{"hypot", "hypot(x - 3, 0)", 0, 0},
                                         DerivativeCase{"floor", "y + floor(x)*1 m", 0, 1},
                                         DerivativeCase{"ceil", "ceil(x)", 0, 0},
                                         DerivativeCase{"round", "round(x - 0.5)", 0, 0},
                                         DerivativeCase{"round_below", "round(x - 5.5)", 0, 0},
                                         DerivativeCase{"mod", "mod(x, 1)", 0, 0},
                                         DerivativeCase{"mod_by", "mod(6, x)", 0, 0},
                                         DerivativeCase{"gcd", "gcd(x, 6)", 0, 0}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(EvaluateDual, ValueIsThatOfDouble) {
  EXPECT_EQ(with_derivatives("x*6 mm").value.value, 3.0 * 0.006);
}

TEST(EvaluateDual, DimensionIsKept) {
  EXPECT_EQ(with_derivatives("y^2").dimension, (Dimension{2, 0, 0, 0}));
}

TEST(EvaluateDual, RootOfZeroHasNoDerivative) {
  EXPECT_FALSE(std::isfinite(derivative(with_derivatives("sqrt(x - 3)").value, 0)));
}

TEST(EvaluateDual, ErrorIsThatOfDouble) {
  const auto parsed = parse_expression("1/(x - 3)");

  const auto result = evaluate<Dual>(std::get<Expression>(parsed), variable_named);

  EXPECT_EQ(std::get<ExpressionError>(result).message, "division by zero");
}

TEST(EvaluateDual, BareNumberTakesTheUnitOfTheFile) {
  FileUnits units;
  units.set(QuantityKind::length, "mm");
  const auto parsed = parse_expression("2*x");

  const auto result =
      evaluate_as<Dual>(QuantityKind::length, std::get<Expression>(parsed), units, variable_named);

  EXPECT_NEAR(std::get<Dual>(result).value, 6e-3, kTight);
  EXPECT_NEAR(derivative(std::get<Dual>(result), 0), 2e-3, kTight);
}

std::vector<Parameter> parameters_of_lines(
    const std::vector<std::pair<std::string, std::string>>& lines) {
  std::vector<Parameter> result;
  for (const auto& [name, value] : lines) {
    result.push_back({name, std::get<Expression>(parse_expression(value)), {}});
  }
  return result;
}

TEST(EvaluateDual, ParametersPassTheirDerivativesOn) {
  const auto list =
      parameters_of_lines({{"area", "width*height"}, {"width", "2"}, {"height", "5"}});
  const std::vector<int> variables = {2, 1};

  const auto values = evaluate_parameters(list, variables);

  const Dual& area = values.table.find("area")->value;
  EXPECT_EQ(derivative(area, 0), 2.0);  // by height
  EXPECT_EQ(derivative(area, 1), 5.0);  // by width
}

TEST(EvaluateDual, VariablesThatUseOthersFollowThem) {
  const auto list = parameters_of_lines({{"a", "3"}, {"b", "2*a"}, {"c", "a*b"}});
  const std::vector<int> variables = {0, 1};

  const auto values = evaluate_parameters(list, variables);

  const Dual& c = values.table.find("c")->value;
  EXPECT_EQ(derivative(values.table.find("b")->value, 0), 2.0);
  EXPECT_EQ(derivative(c, 0), 12.0);  // of 2 a^2
  EXPECT_EQ(derivative(c, 1), 3.0);   // with a as it is
}

TEST(EvaluateDual, ParameterErrorsAreThoseOfDouble) {
  const auto list = parameters_of_lines({{"a", "b"}, {"b", "a"}, {"c", "1/0"}});
  const std::vector<int> variables = {2};

  const auto values = evaluate_parameters(list, variables);

  ASSERT_EQ(values.errors.size(), 2U);
  EXPECT_EQ(values.errors[0].error.code, "E0310");
  EXPECT_EQ(values.errors[1].error.code, "E0316");
}

}  // namespace
}  // namespace kinestat
