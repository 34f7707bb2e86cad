#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "expression/evaluate.hpp"

namespace kinestat {
namespace {

// A text together with the value that its maker computed beside it.
struct Sample {
  std::string text;
  double value = 0.0;
  double size = 0.0;  // sum of magnitudes, which scales the rounding error
};

// Random sums, products and quotients of lengths, always grouped as the text is grouped: a sum has
// parentheses, a factor and a divisor none.
class SampleMaker {
 public:
  explicit SampleMaker(unsigned seed) : random_(seed) {}

  Sample length(int depth) {
    if (depth == 0) {
      return measure();
    }
    const Sample a = length(depth - 1);
    const Sample b = length(depth - 1);
    switch (pick(4)) {
      case 0:
        return {fmt::format("({} + {})", a.text, b.text), a.value + b.value, a.size + b.size};
      case 1:
        return {fmt::format("({} - {})", a.text, b.text), a.value - b.value, a.size + b.size};
      case 2:
        return scaled(a);
      default:
        return {fmt::format("abs({})", a.text), std::abs(a.value), a.size};
    }
  }

 private:
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

  Sample measure() {
    struct Row {
      const char* unit;
      double size;
    };

    constexpr Row kRows[] = {{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"in", 0.0254}};
    const int count = pick(999) + 1;
    const Row row = kRows[pick(4)];
    const char* const join = pick(2) == 0 ? " " : "*";
    const double value = count / 8.0 * row.size;
    return {fmt::format("{}{}{}", count / 8.0, join, row.unit), value, value};
  }

  Sample scaled(const Sample& a) {
    const int top = pick(9) + 1;
    const int bottom = pick(9) + 1;
    const int exponent = pick(3) + 1;
    const double factor = -top / std::pow(bottom, exponent);
    return {fmt::format("-{}*{}/{}^{}", top, a.text, bottom, exponent),
            factor * a.value,
            std::abs(factor) * a.size};
  }

  std::mt19937 random_;
};

TEST(Evaluate, AgreesWithTheMakerOfRandomExpressions) {
  constexpr double kRelative = 1e-13;  // some hundred roundings of 1e-16 each
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const Sample sample = SampleMaker(seed).length(static_cast<int>(seed % 6));

    const auto parsed = parse_expression(sample.text);
    ASSERT_TRUE(std::holds_alternative<Expression>(parsed)) << sample.text;
    const auto result = evaluate(std::get<Expression>(parsed), no_names);

    ASSERT_TRUE(std::holds_alternative<Quantity>(result))
        << sample.text << ": " << std::get<ExpressionError>(result).message;
    EXPECT_EQ(std::get<Quantity>(result).dimension, (Dimension{1, 0, 0, 0})) << sample.text;
    EXPECT_NEAR(std::get<Quantity>(result).value, sample.value, kRelative * sample.size)
        << sample.text;
  }
}

}  // namespace
}  // namespace kinestat
