#include "math/numbers/dual.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "math/numbers/dual_vector.hpp"

namespace kinestat {
namespace {

constexpr double kTight = 1e-14;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kLn2 = std::numbers::ln2;

Dual x(double value) {
  return make_variable(value, 0, 2);
}

Dual y(double value) {
  return make_variable(value, 1, 2);
}

struct SlopeCase {
  const char* name;
  Dual number;
  double value;
  double by_x;
  double by_y;
};

class Slopes : public testing::TestWithParam<SlopeCase> {};

bool is_same(double actual, double expected) {
  return std::isnan(expected) ? std::isnan(actual) : std::abs(actual - expected) <= kTight;
}

TEST_P(Slopes, AreThoseOfTheTextbook) {
  const SlopeCase& row = GetParam();

  EXPECT_NEAR(row.number.value, row.value, kTight);
  EXPECT_PRED2(is_same, derivative(row.number, 0), row.by_x);
  EXPECT_PRED2(is_same, derivative(row.number, 1), row.by_y);
}

std::string name_of_slope(const testing::TestParamInfo<SlopeCase>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Smooth,
    Slopes,
    testing::Values(SlopeCase{"constant", Dual{3.0, {}}, 3, 0, 0},
                    SlopeCase{"variable", y(3), 3, 0, 1},
                    SlopeCase{"opposite", -x(3), -3, -1, 0},
                    SlopeCase{"sum", x(3) + y(4), 7, 1, 1},
                    SlopeCase{"difference", x(3) - y(4), -1, 1, -1},
                    SlopeCase{"product", x(3) * y(4), 12, 4, 3},
                    SlopeCase{"quotient", x(3) / y(4), 0.75, 0.25, -0.1875},
                    SlopeCase{"with_constant", Dual{2.0, {}} * x(3), 6, 2, 0},
                    SlopeCase{"constant_divisor", x(3) / Dual{2.0, {}}, 1.5, 0.5, 0},
                    SlopeCase{"sine", sin(x(0)), 0, 1, 0},
                    SlopeCase{"cosine", cos(x(std::numbers::pi / 2)), 0, -1, 0},
                    SlopeCase{"tangent", tan(x(std::numbers::pi / 4)), 1, 2, 0},
                    SlopeCase{"arcsine", asin(x(0.6)), std::asin(0.6), 1.25, 0},
                    SlopeCase{"arccosine", acos(x(0.6)), std::acos(0.6), -1.25, 0},
                    SlopeCase{"arctangent", atan(x(2)), std::atan(2), 0.2, 0},
                    SlopeCase{"angle_of_a_point", atan2(y(3), x(4)), std::atan2(3, 4), -0.12, 0.16},
                    SlopeCase{"angle_behind", atan2(y(0), x(-2)), std::numbers::pi, 0, -0.5},
                    SlopeCase{"root", sqrt(x(4)), 2, 0.25, 0},
                    SlopeCase{"exponential", exp(x(0)), 1, 1, 0},
                    SlopeCase{"logarithm", log(x(4)), 2 * kLn2, 0.25, 0},
                    SlopeCase{"decimal_logarithm", log10(x(10)), 1, 0.1 / std::numbers::ln10, 0},
                    SlopeCase{"power", pow(x(2), y(3)), 8, 12, 8 * kLn2},
                    SlopeCase{"power_of_a_negative", pow(x(-2), Dual{3.0, {}}), -8, 12, 0},
                    SlopeCase{"power_nought", pow(x(0), Dual{0.0, {}}), 1, 0, 0},
                    SlopeCase{"zero_to_a_power", pow(x(0), y(2)), 0, 0, 0},
                    SlopeCase{"first_power_of_zero", pow(x(0), Dual{1.0, {}}), 0, 1, 0},
                    SlopeCase{"smaller", min(x(1), y(2)), 1, 1, 0},
                    SlopeCase{"larger", max(x(1), y(2)), 2, 0, 1},
                    SlopeCase{"hypotenuse", hypot(x(3), y(4)), 5, 0.6, 0.8}),
    name_of_slope);

INSTANTIATE_TEST_SUITE_P(
    Kinks,
    Slopes,
    testing::Values(
        SlopeCase{"abs_above", abs(x(2)), 2, 1, 0},
        SlopeCase{"abs_below", abs(x(-2)), 2, -1, 0},
        SlopeCase{"abs_at_zero", abs(x(0)), 0, kNone, 0},
        SlopeCase{"equal_smaller", min(x(2), y(2)), 2, kNone, kNone},
        SlopeCase{"equal_larger", max(x(2), y(2)), 2, kNone, kNone},
        SlopeCase{"equal_but_for_rounding", max(x(0.1) + y(0.2), Dual{0.3, {}}), 0.3, kNone, kNone},
        SlopeCase{"both_sides_alike", max(x(1) + y(1), x(2)), 2, 1, kNone},
        SlopeCase{"hypotenuse_at_the_origin", hypot(x(0), y(0)), 0, kNone, kNone},
        SlopeCase{"jump", staircase(3.0, true, x(3)), 3, kNone, 0},
        SlopeCase{"between_jumps", staircase(3.0, false, x(3.5)), 3, 0, 0},
        SlopeCase{"root_of_zero", sqrt(x(0)), 0, kNone, 0},
        SlopeCase{"arcsine_of_one", asin(x(1)), std::numbers::pi / 2, kNone, 0},
        SlopeCase{"arccosine_of_minus_one", acos(x(-1)), std::numbers::pi, kNone, 0},
        SlopeCase{"broken_power_of_zero", pow(x(0), Dual{0.5, {}}), 0, kNone, 0},
        SlopeCase{"exponent_of_a_negative", pow(Dual{-2.0, {}}, y(2)), 4, 0, kNone},
        SlopeCase{"angle_of_the_origin", atan2(y(0), x(0)), 0, kNone, kNone},
        SlopeCase{"none_stays_none", sqrt(x(0)) * Dual{2.0, {}}, 0, kNone, 0},
        SlopeCase{"nothing_times_a_corner", abs(x(0)) * Dual{0.0, {}} + y(2), 2, 0, 1}),
    name_of_slope);

TEST(Dual, ArcsineNearOneKeepsItsDigits) {
  // d asin = 1/sqrt(2 e - e^2) with e = 2^-40.
  const double e = std::ldexp(1.0, -40);

  EXPECT_NEAR(derivative(asin(x(1.0 - e)), 0) * std::sqrt(2 * e - e * e), 1.0, kTight);
}

// Whatever is longer or shorter by x: the direction stays.
TEST(DualVector, DoesNotTurnWhereItOnlyGrows) {
  for (const double size : {1.0, 0.37, 157.08, 3e-7}) {
    for (const Vec3& along : {Vec3(0.3, -0.7, 0.11), Vec3(2.0, 0.4, 0.0), Vec3(1.0, 1.0, 1.0)}) {
      const Vec3Of<Dual> unit =
          unit_along<Dual>({x(size) * along.x(), x(size) * along.y(), x(size) * along.z()});
      for (const Dual& one : unit) {
        EXPECT_EQ(derivative(one, 0), 0.0) << size;
      }
    }
  }
}

// Of (x, y, 0) at (3, 4): d(x/r)/dx = y^2/r^3, d(x/r)/dy = -xy/r^3.
TEST(DualVector, TurnsAsTheTextbookSays) {
  const Vec3Of<Dual> unit = unit_along<Dual>({x(3), y(4), Dual(0.0)});

  EXPECT_NEAR(derivative(unit[0], 0), 0.128, kTight);
  EXPECT_NEAR(derivative(unit[0], 1), -0.096, kTight);
  EXPECT_NEAR(derivative(unit[1], 1), 0.072, kTight);
  EXPECT_EQ(derivative(unit[2], 0), 0.0);
}

}  // namespace
}  // namespace kinestat
