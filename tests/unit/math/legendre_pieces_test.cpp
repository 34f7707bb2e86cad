#include "math/dense/legendre_pieces.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr LegendrePieces::Limits kFine = {
    .tail = 1e-13, .noise = 1e-9, .finest = 1e-10, .most = 5000};

FunctionsAt one(double (*function)(double)) {
  return [function](double x) {
    return std::optional(
        FunctionValues{.values = VecX::Constant(1, function(x)), .sizes = VecX::Constant(1, 1.0)});
  };
}

LegendrePieces pieces_of(double (*function)(double), double to) {
  const std::array places = {0.0, 0.5 * to, to};
  return *LegendrePieces::find(one(function), places, kFine);
}

// Abramowitz and Stegun, table 25.4.
TEST(GaussPoints, AreThoseOfTheTables) {
  const GaussPoints rule = gauss_points(5);

  EXPECT_NEAR(rule.points[4], 0.906179845938664, 1e-15);
  EXPECT_NEAR(rule.weights[4], 0.236926885056189, 1e-15);
  EXPECT_NEAR(rule.points[2], 0.0, 1e-16);
  EXPECT_NEAR(rule.weights[2], 0.568888888888889, 1e-15);
}

TEST(LegendrePieces, IntegrateUpToAnyPlace) {
  const LegendrePieces wave = pieces_of([](double x) { return std::cos(7.0 * x); }, 2.0 * kPi);

  for (const double x : {0.0, 0.3, kPi, 5.0, 2.0 * kPi}) {
    EXPECT_NEAR(wave.value(0, x), std::cos(7.0 * x), 1e-12) << x;
    EXPECT_NEAR(wave.integral(0, x), std::sin(7.0 * x) / 7.0, 1e-13) << x;
  }
}

TEST(LegendrePieces, IntegrateWhatTurnsACorner) {
  const LegendrePieces corner = pieces_of([](double x) { return std::abs(x - 1.0 / 3.0); }, 1.0);

  EXPECT_NEAR(corner.integral(0), 1.0 / 18.0 + 4.0 / 18.0, 1e-13);
}

TEST(LegendrePieces, IntegrateWhatJumps) {
  const LegendrePieces jump = pieces_of([](double x) { return x < 1.0 / 3.0 ? -1.0 : 1.0; }, 1.0);

  EXPECT_NEAR(jump.integral(0), 1.0 / 3.0, 1e-9);
}

// What looks random to eleven digits stands for rounding.
TEST(LegendrePieces, AreNoFinerForRounding) {
  const LegendrePieces rough =
      pieces_of([](double x) { return std::cos(x) + 1e-11 * std::sin(1e7 * x); }, 2.0 * kPi);

  EXPECT_LT(rough.pieces().size(), 40U);
  EXPECT_NEAR(rough.integral(0, 0.5 * kPi), 1.0, 1e-10);
}

// Two jumps of which the even division into as many pieces as there may be would have one piece.
TEST(LegendrePieces, IntegrateWhatJumpsTwiceInAMoment) {
  const LegendrePieces stairs = pieces_of(
      [](double x) { return std::abs(x - 0.3) < 1e-5 ? 0.0
                            : x < 0.3                ? -1.0
                                                     : 1.0; }, 1.0);

  EXPECT_NEAR(stairs.integral(0), 0.4, 1e-9);
}

// Rounding of the eighth digit: finer pieces would know no more, and are not looked at one by one.
TEST(LegendrePieces, GiveUpSoonWhereRoundingIsLarge) {
  int looked = 0;
  const FunctionsAt rough = [&looked](double x) {
    ++looked;
    const double value = std::cos(x) + 1e-8 * std::sin(1e9 * (x + 1.0) * (x + 1.0));
    return std::optional(
        FunctionValues{.values = VecX::Constant(1, value), .sizes = VecX::Ones(1)});
  };

  const std::array places = {0.0, kPi, 2.0 * kPi};
  EXPECT_FALSE(LegendrePieces::find(rough, places, kFine));
  EXPECT_LT(looked, 1000);
}

TEST(LegendrePieces, TakeProductsAtTheirPoints) {
  const LegendrePieces wave = pieces_of([](double x) { return std::sin(x); }, 2.0 * kPi);

  double sum = 0.0;
  wave.for_each_point(0.1, [&](double x, double weight, const VecX& values) {
    sum += weight * values[0] * std::sin(30.0 * x) * std::cos(29.0 * x);
  });

  EXPECT_NEAR(sum, 0.5 * kPi, 1e-12);
}

TEST(LegendrePieces, FindTheGreatestOfSeveralPeaks) {
  const LegendrePieces wave =
      pieces_of([](double x) { return std::sin(x) + 0.9 * std::sin(5.0 * x); }, 2.0 * kPi);

  const GreatestValue top = wave.greatest([&](double x) { return wave.value(0, x); });

  // Both are greatest there.
  EXPECT_NEAR(top.argument, 0.5 * kPi, 1e-9);
  EXPECT_NEAR(top.value, 1.9, 1e-12);
}

TEST(LegendrePieces, FindTheFirstOfEqualPeaks) {
  // Rounding makes each a little higher than the one before it.
  const LegendrePieces waves =
      pieces_of([](double x) { return (1.0 + 1e-13 * x) * std::sin(x); }, 8.0 * kPi);

  const GreatestValue top = waves.greatest([&](double x) { return std::abs(waves.value(0, x)); });

  EXPECT_NEAR(top.argument, 0.5 * kPi, 1e-8);
  EXPECT_NEAR(top.value, 1.0, 1e-11);
}

TEST(LegendrePieces, FindTheBeginOfWhatStaysGreatest) {
  const LegendrePieces flat =
      pieces_of([](double x) { return 1.0 + 1e-15 * std::sin(x); }, 8.0 * kPi);

  EXPECT_EQ(flat.greatest([&](double x) { return flat.value(0, x); }).argument, 0.0);
}

TEST(LegendrePieces, AreNoneWhereAPlaceHasNoValue) {
  const FunctionsAt holed = [](double x) -> std::optional<FunctionValues> {
    if (x > 0.7) {
      return std::nullopt;
    }
    return FunctionValues{.values = VecX::Ones(1), .sizes = VecX::Ones(1)};
  };

  const std::array places = {0.0, 1.0};
  EXPECT_FALSE(LegendrePieces::find(holed, places, kFine));
}

}  // namespace
}  // namespace kinestat
