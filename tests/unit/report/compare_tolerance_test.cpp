#include "studies/compare/compare_tolerance.hpp"

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

Tolerances tolerances(const std::vector<std::string>& rules,
                      const std::string& rtol = "",
                      const std::string& atol = "") {
  Diagnostics found;
  const auto result = read_tolerances({.rtol = rtol, .atol = atol, .tolerances = rules}, found);
  EXPECT_TRUE(result.has_value());
  return result.value_or(Tolerances{});
}

std::string tolerance_complaint(const std::string& rule,
                                const std::string& rtol = "",
                                const std::string& atol = "") {
  Diagnostics found;
  const std::vector<std::string> rules =
      rule.empty() ? std::vector<std::string>{} : std::vector{rule};
  EXPECT_FALSE(read_tolerances({.rtol = rtol, .atol = atol, .tolerances = rules}, found));
  return found.items().size() == 1 ? found.items().front().message : "not one message";
}

ValueUnit unit(const std::string& text) {
  return std::get<ValueUnit>(read_unit(text));
}

double allowed(double a, double b, const std::string& in, const Tolerances& by, double most = 0.0) {
  const ValueUnit shown = unit(in);
  return allowed_difference(
      {.place = "/cases/M1/statics/actions/C1", .a = a, .b = b, .unit = shown, .largest = most},
      by);
}

// A derivative of a quotient: (rad/s)/(mm/s)/mm = 1e6 rad/m^2.
TEST(ReadUnit, DividesByOneUnitAfterTheOther) {
  EXPECT_DOUBLE_EQ(unit("rad/s per mm/s per mm").scale.to_si(1.0), 1e6);
  EXPECT_EQ(unit("rad/s per mm/s per mm").dimension, unit("rad/m^2").dimension);
  EXPECT_DOUBLE_EQ(unit("rad/s/(mm/s)/mm").scale.to_si(1.0), 1e6);
  EXPECT_EQ(unit("rad/s/(mm/s)/mm").dimension, unit("rad/m^2").dimension);
  EXPECT_DOUBLE_EQ(unit("1/mm").scale.to_si(1.0), 1e3);
}

TEST(Tolerance, IsAShareOfTheLargerValueByDefault) {
  EXPECT_DOUBLE_EQ(allowed(-2.0, 1.0, "N", tolerances({})), 2e-9);
}

TEST(Tolerance, IsAShareOfTheLargestOfItsKindNearZero) {
  EXPECT_DOUBLE_EQ(allowed(0.0, 1e-14, "N", tolerances({}), 100.0), 1e-10);
}

TEST(Tolerance, IsAsTheOptionsSay) {
  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "N", tolerances({}, "0.1", "0")), 0.2);
  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "N", tolerances({}, "0", "0.5"), 100.0), 0.5);
}

TEST(Tolerance, OfAKindTakesThePlaceOfTheOthers) {
  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "N*m", tolerances({"moment=1e-6"}, "0.1")), 1e-6);
  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "N", tolerances({"moment=1e-6"}, "0.1")), 0.2);
}

TEST(Tolerance, CountsInTheUnitOfTheValue) {
  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "N*mm", tolerances({"moment=0.5"})), 0.5);
}

TEST(Tolerance, MayHaveAUnit) {
  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "N*m", tolerances({"moment=2 N*mm"})), 0.002);
}

TEST(Tolerance, WithAUnitIsForValuesOfThisDimension) {
  const Tolerances by = tolerances({"/cases=1 N"}, "0");

  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "kN", by), 0.001);
  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "N*m", by), 0.0);
}

TEST(Tolerance, OfEnergyIsForUnitsWithANameOfTheirOwn) {
  const Tolerances by = tolerances({"energy=2 J", "moment=3 N*m"}, "0");

  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "kJ", by), 0.002);
  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "N*mm", by), 3000.0);
  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "Nm", by), 3.0);
}

TEST(Tolerance, OfAStiffnessAboutAnAxisIsNotForMoments) {
  const Tolerances by = tolerances({"angular_stiffness=2 N*m/rad"}, "0");

  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "N*mm/rad", by), 2000.0);
  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "N*m", by), 0.0);
}

// A kind that tolerances may name, and a unit of which no value has it, would never hold.
TEST(Tolerance, OfEveryKindHasItsUnits) {
  for (const QuantityKind kind : all_quantity_kinds()) {
    std::string word(name_of(kind));
    std::ranges::replace(word, ' ', '_');
    if (std::ranges::find(value_kinds(), word) == value_kinds().end()) {
      continue;
    }
    const std::string text = kind == QuantityKind::energy ? "J" : si_unit_of(dimension_of(kind));

    EXPECT_EQ(unit(text).kind, word) << text;
    EXPECT_EQ(tolerances({word + "=1 " + text}).rules.size(), 1U);
  }
}

TEST(Tolerance, MayBeAPercentage) {
  EXPECT_DOUBLE_EQ(allowed(2.0, -4.0, "N", tolerances({"force=0.1%"})), 0.004);
}

TEST(Tolerance, OfAPlaceIsForAllBelowIt) {
  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "N", tolerances({"/cases/*/statics=3"})), 3.0);
  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "N", tolerances({"/cases/M2=3"}, "0")), 0.0);
}

TEST(Tolerance, OfALabelWithAnEqualsSignIsRead) {
  EXPECT_EQ(tolerances({"/cases/x=1/ratio=3"}).rules.front().key, "/cases/x=1/ratio");
}

TEST(Tolerance, IsTheLastThatFits) {
  EXPECT_DOUBLE_EQ(allowed(2.0, 1.0, "N", tolerances({"/cases=3", "force=4", "moment=5"})), 4.0);
}

TEST(Tolerance, OfCountsIsZeroUnlessTheyAreNamed) {
  const ValueUnit count = count_unit();
  const NumberPair pair{.place = "/mobility", .a = 2.0, .b = 3.0, .unit = count, .largest = 9.0};

  EXPECT_EQ(allowed_difference(pair, tolerances({}, "1", "5")), 0.0);
  EXPECT_EQ(allowed_difference(pair, tolerances({"count=1"})), 1.0);
}

TEST(Tolerance, IsMetByADifferenceOfExactlyIt) {
  const ValueUnit newton = unit("N");

  EXPECT_TRUE(are_equal({.place = "", .a = 2.0, .b = 2.1, .unit = newton, .largest = 0.0}, 0.1));
  EXPECT_TRUE(
      are_equal({.place = "", .a = 1e6, .b = 1e6 + 0.1, .unit = newton, .largest = 0.0}, 0.1));
  EXPECT_TRUE(are_equal({.place = "", .a = 0.0, .b = 0.1, .unit = newton, .largest = 0.0}, 0.1));
}

TEST(Tolerance, IsMissedByADifferenceBeyondIt) {
  const ValueUnit newton = unit("N");

  EXPECT_FALSE(
      are_equal({.place = "", .a = 2.0, .b = 2.1000001, .unit = newton, .largest = 0.0}, 0.1));
}

TEST(Tolerance, OfZeroAsksForTheSameNumber) {
  const ValueUnit newton = unit("N");

  EXPECT_FALSE(
      are_equal({.place = "", .a = 0.3, .b = 0.1 + 0.2, .unit = newton, .largest = 0.0}, 0.0));
  EXPECT_TRUE(are_equal({.place = "", .a = 0.3, .b = 0.3, .unit = newton, .largest = 0.0}, 0.0));
}

TEST(Tolerance, IsRefusedForAnUnknownKind) {
  EXPECT_EQ(tolerance_complaint("torque=1"),
            "--tolerance 'torque=1': there is no kind of quantity 'torque'");
}

TEST(Tolerance, IsRefusedIfItIsNoKeyAndValue) {
  EXPECT_EQ(tolerance_complaint("moment"), "--tolerance 'moment': this is not KEY=VALUE");
  EXPECT_EQ(tolerance_complaint("=1"), "--tolerance '=1': this is not KEY=VALUE");
}

TEST(Tolerance, IsRefusedIfItIsNoNumber) {
  EXPECT_EQ(tolerance_complaint("moment=small"),
            "--tolerance 'moment=small': unknown name 'small'");
  EXPECT_EQ(tolerance_complaint("moment=-1"),
            "--tolerance 'moment=-1': a tolerance is not negative");
  EXPECT_EQ(tolerance_complaint("moment=1 N%"),
            "--tolerance 'moment=1 N%': a percentage has no unit");
  EXPECT_EQ(tolerance_complaint("", "nan"), "--rtol 'nan': 'nan' is not a finite number");
}

TEST(Tolerance, IsRefusedIfItMeasuresSomethingElse) {
  EXPECT_EQ(tolerance_complaint("moment=1 N"),
            "--tolerance 'moment=1 N': this is a force, not of the kind 'moment'");
}

TEST(Tolerance, ForEveryKindHasNoUnit) {
  EXPECT_EQ(tolerance_complaint("", "", "1 mm"),
            "--atol '1 mm': this is for values of every kind, so it is a bare number");
}

}  // namespace
}  // namespace kinestat
