// Random expressions: the library against the meaning that their maker works out beside them.
#include <cmath>
#include <string>
#include <variant>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "expression/evaluate.hpp"
#include "expression/exact.hpp"
#include "math/numbers/dual.hpp"
#include "property/expression_sample.hpp"

namespace kinestat {
namespace {

using sample::Meaning;
using sample::Verdict;

constexpr int kShardCount = 20;
constexpr unsigned kSeedsPerShard = 1500;
constexpr long double kSlope = 1e-7L;  // relative to the sum of magnitudes

const std::vector<sample::Powers> kRoots = {
    {0, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 1}, {0, 0, -1, 1}, {2, 1, -2, 0}, {1, 1, -2, 0}};

Dimension dimension_of(const sample::Powers& powers) {
  return {powers[0], powers[1], powers[2], powers[3]};
}

template <class Number>
Number number_of(std::size_t index);

template <>
double number_of(std::size_t index) {
  return sample::names()[index].thousandths / 1000.0;
}

template <>
Exact number_of(std::size_t index) {
  return {number_of<double>(index),
          PiRational{Rational(sample::names()[index].thousandths, 1000), 0}};
}

template <>
Dual number_of(std::size_t index) {
  for (std::size_t i = 0; i < sample::kVariables.size(); ++i) {
    if (sample::kVariables[i] == index) {
      return make_variable(number_of<double>(index), i, sample::kVariables.size());
    }
  }
  return {number_of<double>(index), {}};
}

template <class Number>
const BasicQuantity<Number>* lookup(std::string_view name) {
  static const auto values = [] {
    std::vector<BasicQuantity<Number>> result;
    for (std::size_t i = 0; i < sample::names().size(); ++i) {
      result.push_back({number_of<Number>(i), dimension_of(sample::names()[i].powers)});
    }
    return result;
  }();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (sample::names()[i].name == name) {
      return &values[i];
    }
  }
  return nullptr;
}

// How many comparisons a shard made, so that a generator gone dull does not pass unnoticed.
struct Count {
  int values = 0;
  int faults = 0;
  int exact = 0;
  int slopes = 0;
};

class RandomExpressions : public testing::TestWithParam<int> {
 protected:
  void check(const Expression& expression, const Meaning& expected);
  void check_fault(const Expression& expression, const Meaning& expected);
  void check_value(const Quantity& actual, const Meaning& expected);
  void check_exact(const Expression& expression, const Meaning& expected);
  void check_slopes(const Expression& expression, const Meaning& expected);

  Count count_;
};

void RandomExpressions::check(const Expression& expression, const Meaning& expected) {
  if (expected.verdict != Verdict::value) {
    check_fault(expression, expected);
    return;
  }
  const auto result = evaluate(expression, lookup<double>);
  ASSERT_TRUE(std::holds_alternative<Quantity>(result))
      << std::get<ExpressionError>(result).message;
  check_value(std::get<Quantity>(result), expected);
  check_exact(expression, expected);
  check_slopes(expression, expected);
}

void RandomExpressions::check_fault(const Expression& expression, const Meaning& expected) {
  ++count_.faults;
  const std::string code = expected.verdict == Verdict::dimension ? "E0309" : "E0316";

  const auto plain = evaluate(expression, lookup<double>);
  const auto exact = evaluate<Exact>(expression, lookup<Exact>);
  const auto dual = evaluate<Dual>(expression, lookup<Dual>);

  ASSERT_TRUE(std::holds_alternative<ExpressionError>(plain));
  ASSERT_TRUE(std::holds_alternative<ExpressionError>(exact));
  ASSERT_TRUE(std::holds_alternative<ExpressionError>(dual));
  const auto& error = std::get<ExpressionError>(plain);
  EXPECT_EQ(error.code, code) << error.message;
  EXPECT_EQ(std::get<ExpressionError>(exact).message, error.message);
  EXPECT_EQ(std::get<ExpressionError>(dual).message, error.message);
}

void RandomExpressions::check_value(const Quantity& actual, const Meaning& expected) {
  ++count_.values;
  EXPECT_EQ(actual.dimension, dimension_of(expected.powers));
  EXPECT_LE(std::abs(actual.value - expected.value), expected.error)
      << actual.value << " is not " << expected.value;
}

void RandomExpressions::check_exact(const Expression& expression, const Meaning& expected) {
  const auto result = evaluate<Exact>(expression, lookup<Exact>);

  const auto& number = std::get<BasicQuantity<Exact>>(result).value;
  ASSERT_EQ(number.exact.has_value(), expected.exact.has_value());
  if (expected.exact) {
    ++count_.exact;
    EXPECT_EQ(number.exact->factor.str(), expected.exact->factor.str());
    EXPECT_EQ(number.exact->pi_power, expected.exact->pi_power);
  }
}

void RandomExpressions::check_slopes(const Expression& expression, const Meaning& expected) {
  const auto result = evaluate<Dual>(expression, lookup<Dual>);

  const Dual& number = std::get<BasicQuantity<Dual>>(result).value;
  EXPECT_LE(std::abs(number.value - expected.value), expected.error);
  for (std::size_t i = 0; expected.is_smooth && i < sample::kVariables.size(); ++i) {
    count_.slopes += expected.slope_sizes[i] > 0 ? 1 : 0;
    EXPECT_LE(std::abs(derivative(number, i) - expected.slopes[i]),
              kSlope * expected.slope_sizes[i])
        << derivative(number, i) << " is not " << expected.slopes[i] << " by variable " << i;
  }
}

TEST_P(RandomExpressions, MeanWhatTheirMakerMeant) {
  for (unsigned i = 0; i < kSeedsPerShard && !HasFailure(); ++i) {
    const unsigned seed = static_cast<unsigned>(GetParam()) * kSeedsPerShard + i;
    std::mt19937 random(seed);
    const sample::Tree tree =
        sample::make_tree(random, kRoots[seed % kRoots.size()], static_cast<int>(seed % 5));
    const Meaning expected = sample::meaning_of(tree);
    const bool has_value = expected.verdict == Verdict::value;
    const std::string text = sample::text_of(
        random, tree, has_value ? sample::Calls::also_flat : sample::Calls::as_nested);
    SCOPED_TRACE(fmt::format("seed {}: {}", seed, text));
    if (expected.verdict == Verdict::unclear) {
      continue;
    }
    const auto parsed = parse_expression(text);
    ASSERT_TRUE(std::holds_alternative<Expression>(parsed))
        << std::get<ExpressionError>(parsed).message;
    check(std::get<Expression>(parsed), expected);
  }
  EXPECT_GE(count_.values, 1000);
  EXPECT_GE(count_.faults, 40);
  EXPECT_GE(count_.exact, 500);
  EXPECT_GE(count_.slopes, 150);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomExpressions, testing::Range(0, kShardCount));

}  // namespace
}  // namespace kinestat
