#include "expression/units.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/angles.hpp"

namespace kinestat {
namespace {

struct UnitCase {
  const char* name;
  const char* text;
  double factor;
  Dimension dimension;
};

class UnitTable : public testing::TestWithParam<UnitCase> {};

TEST_P(UnitTable, HasItsSizeAndDimension) {
  const auto parsed = parse_unit(GetParam().text);

  ASSERT_TRUE(std::holds_alternative<UnitExpression>(parsed))
      << std::get<ExpressionError>(parsed).message;
  const auto& unit = std::get<UnitExpression>(parsed);
  EXPECT_DOUBLE_EQ(unit.scale.factor(), GetParam().factor);
  EXPECT_EQ(unit.dimension, GetParam().dimension);
  EXPECT_EQ(unit.text, GetParam().text);
}

// Sizes from the definitions of the SI brochure; the inch is exactly 25.4 mm. Those of feet and
// pounds from NIST SP 811 (2008), appendix B.
INSTANTIATE_TEST_SUITE_P(
    Table,
    UnitTable,
    testing::Values(UnitCase{"metre", "m", 1.0, {1, 0, 0, 0}},
                    UnitCase{"millimetre", "mm", 1e-3, {1, 0, 0, 0}},
                    UnitCase{"micrometre", "um", 1e-6, {1, 0, 0, 0}},
                    UnitCase{"centimetre", "cm", 1e-2, {1, 0, 0, 0}},
                    UnitCase{"kilometre", "km", 1e3, {1, 0, 0, 0}},
                    UnitCase{"inch", "in", 0.0254, {1, 0, 0, 0}},
                    UnitCase{"radian", "rad", 1.0, {0, 0, 0, 1}},
                    UnitCase{"degree", "deg", kPi / 180, {0, 0, 0, 1}},
                    UnitCase{"turn", "rev", 2 * kPi, {0, 0, 0, 1}},
                    UnitCase{"second", "s", 1.0, {0, 0, 1, 0}},
                    UnitCase{"minute", "min", 60.0, {0, 0, 1, 0}},
                    UnitCase{"hour", "h", 3600.0, {0, 0, 1, 0}},
                    UnitCase{"kilogram", "kg", 1.0, {0, 1, 0, 0}},
                    UnitCase{"gram", "g", 1e-3, {0, 1, 0, 0}},
                    UnitCase{"newton", "N", 1.0, {1, 1, -2, 0}},
                    UnitCase{"kilonewton", "kN", 1e3, {1, 1, -2, 0}},
                    UnitCase{"newton_metre", "Nm", 1.0, {2, 1, -2, 0}},
                    UnitCase{"newton_mm", "N*mm", 1e-3, {2, 1, -2, 0}},
                    UnitCase{"kilonewton_metre", "kN*m", 1e3, {2, 1, -2, 0}},
                    UnitCase{"rpm", "rpm", kPi / 30, {0, 0, -1, 1}},
                    UnitCase{"turns_a_minute", "rev/min", kPi / 30, {0, 0, -1, 1}},
                    UnitCase{"watt", "W", 1.0, {2, 1, -3, 0}},
                    UnitCase{"kilowatt", "kW", 1e3, {2, 1, -3, 0}},
                    UnitCase{"mm_per_second", "mm/s", 1e-3, {1, 0, -1, 0}},
                    UnitCase{"acceleration", "m/s^2", 1.0, {1, 0, -2, 0}},
                    UnitCase{"per_second", "1/s", 1.0, {0, 0, -1, 0}},
                    UnitCase{"degree_sign", "\u00B0", kPi / 180, {0, 0, 0, 1}},
                    UnitCase{"foot", "ft", 0.3048, {1, 0, 0, 0}},
                    UnitCase{"millisecond", "ms", 1e-3, {0, 0, 1, 0}},
                    UnitCase{"pound", "lb", 0.45359237, {0, 1, 0, 0}},
                    UnitCase{"weight_of_a_kilogram", "kgf", 9.80665, {1, 1, -2, 0}},
                    UnitCase{"weight_of_a_pound", "lbf", 0.45359237 * 9.80665, {1, 1, -2, 0}},
                    UnitCase{"foot_pound", "ft*lbf", 1.3558179483314004, {2, 1, -2, 0}},
                    UnitCase{"joule", "J", 1.0, {2, 1, -2, 0}},
                    UnitCase{"hertz", "Hz", 2 * kPi, {0, 0, -1, 1}},
                    UnitCase{"horsepower", "hp", 745.69987158227022, {2, 1, -3, 0}},
                    UnitCase{"pascal", "Pa", 1.0, {-1, 1, -2, 0}},
                    UnitCase{"megapascal", "MPa", 1e6, {-1, 1, -2, 0}},
                    UnitCase{"pound_per_square_inch", "psi", 6894.757293168361, {-1, 1, -2, 0}},
                    UnitCase{"moment_per_degree", "N*m/deg", 180 / kPi, {2, 1, -2, -1}}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(Units, EveryListedNameIsFound) {
  ASSERT_EQ(unit_names().size(), 36U);
  for (const std::string& name : unit_names()) {
    EXPECT_NE(find_unit(name), nullptr) << name;
  }
}

TEST(Units, UpperCaseIsAnotherName) {
  EXPECT_EQ(find_unit("MM"), nullptr);
}

TEST(Units, MillimetresRoundOnce) {
  EXPECT_EQ(find_unit("mm")->scale.to_si(6.0), 0.006);
}

TEST(Units, FromSiUndoesToSi) {
  const UnitScale scale = find_unit("rpm")->scale;

  EXPECT_DOUBLE_EQ(scale.from_si(scale.to_si(1500.0)), 1500.0);
}

TEST(Units, QuotientOfAUnitByItselfIsOne) {
  const UnitScale scale = find_unit("deg")->scale;

  EXPECT_DOUBLE_EQ((scale / scale).factor(), 1.0);
}

struct UnitFault {
  const char* name;
  const char* text;
  int offset;
  const char* message;
  const char* hint;
};

class UnitFaults : public testing::TestWithParam<UnitFault> {};

TEST_P(UnitFaults, AreNamedAtTheirPlace) {
  const auto parsed = parse_unit(GetParam().text);

  ASSERT_TRUE(std::holds_alternative<ExpressionError>(parsed));
  const auto& error = std::get<ExpressionError>(parsed);
  EXPECT_EQ(error.offset, GetParam().offset);
  EXPECT_EQ(error.code, "E0308");
  EXPECT_NE(error.message.find(GetParam().message), std::string::npos) << error.message;
  EXPECT_NE(error.hint.find(GetParam().hint), std::string::npos) << error.hint;
}

INSTANTIATE_TEST_SUITE_P(
    Table,
    UnitFaults,
    testing::Values(UnitFault{"case_matters", "MM", 0, "unknown unit 'MM'", "'mm'"},
                    UnitFault{"misspelled", "N*degre", 2, "unknown unit 'degre'", "'deg'"},
                    UnitFault{"unknown_prefix", "mNm", 0, "unknown unit 'mNm'", "'N*mm'"},
                    UnitFault{
                        "nothing_near", "furlong", 0, "unknown unit 'furlong'", "units are m"},
                    UnitFault{"point_for_product", "N.m", 1, "'.'", "write *"},
                    UnitFault{"number", "5 mm", 0, "carries no number", "alone"},
                    UnitFault{"one_before", "1 mm", 0, "carries no number", "alone"},
                    UnitFault{"factor", "W*1", 2, "carries no number", "alone"},
                    UnitFault{"divisor", "mm/1", 3, "carries no number", "alone"},
                    UnitFault{"one", "1", 0, "not a unit", "mm"},
                    UnitFault{"sum", "m+m", 0, "made of unit names", "N*mm"},
                    UnitFault{"broken_power", "m^0.5", 2, "whole number", "s^2"},
                    UnitFault{"empty", "", 0, "empty", "number"}),
    [](const auto& row) { return std::string(row.param.name); });

// Typed with up to as many figures as a double keeps.
TEST(WrittenNumber, ComesBackAsItWasTyped) {
  std::mt19937_64 random(20261201);
  std::uniform_real_distribution<double> mantissa(1.0, 10.0);
  for (const std::string& name : unit_names()) {
    const UnitScale& scale = find_unit(name)->scale;
    for (int i = 0; i < 20'000; ++i) {
      const int figures = 1 + i % 15;
      const int power = i % 12 - 6;
      const double typed =
          std::stod(fmt::format("{:.{}e}", mantissa(random) * std::pow(10.0, power), figures - 1));
      ASSERT_EQ(scale.written_from_si(scale.to_si(typed)), typed) << name;
      ASSERT_EQ(scale.written_from_si(scale.to_si(-typed)), -typed) << name;
    }
  }
}

TEST(WrittenNumber, IsThatOfTheUnitWhereNothingWasTyped) {
  const UnitScale& rpm = find_unit("rpm")->scale;
  const double speed = std::sqrt(2.0);

  EXPECT_EQ(rpm.written_from_si(speed), rpm.from_si(speed));
  EXPECT_EQ(rpm.written_from_si(0.0), 0.0);
  EXPECT_EQ(rpm.written_from_si(std::numeric_limits<double>::infinity()),
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace kinestat
