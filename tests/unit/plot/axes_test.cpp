#include "draw/axes.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

std::vector<std::string> labels_of(const AxisRange& axis) {
  std::vector<std::string> labels;
  for (const Tick& tick : axis.ticks) {
    labels.push_back(tick.label);
  }
  return labels;
}

using Labels = std::vector<std::string>;

TEST(Axes, StepBy1And2And5) {
  EXPECT_EQ(labels_of(linear_axis({.low = 0.0, .high = 9.0, .tick_count = 5})),
            Labels({"0", "2", "4", "6", "8", "10"}));
  EXPECT_EQ(labels_of(linear_axis({.low = 0.1, .high = 0.42, .tick_count = 4})),
            Labels({"0.1", "0.2", "0.3", "0.4", "0.5"}));
  EXPECT_EQ(labels_of(linear_axis({.low = -30.0, .high = 90.0, .tick_count = 3})),
            Labels({"−50", "0", "50", "100"}));
}

TEST(Axes, EndAtATickThatRoundingPasses) {
  EXPECT_EQ(labels_of(linear_axis({.low = -1e-17, .high = 1.0 + 1e-15, .tick_count = 6})),
            Labels({"0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
}

TEST(Axes, StepNoFinerThanTheValues) {
  EXPECT_EQ(labels_of(tight_axis({.low = 0.0, .high = 4.0, .tick_count = 8, .least_step = 1.0})),
            Labels({"0", "1", "2", "3", "4"}));
  EXPECT_EQ(labels_of(tight_axis({.low = 0.0, .high = 40.0, .tick_count = 8, .least_step = 1.0})),
            Labels({"0", "5", "10", "15", "20", "25", "30", "35", "40"}));
}

TEST(Axes, StepByPartsOfATurnInDegrees) {
  EXPECT_EQ(
      labels_of(linear_axis({.low = 0.0, .high = 360.0, .tick_count = 8, .in_degrees = true})),
      Labels({"0", "45", "90", "135", "180", "225", "270", "315", "360"}));
  EXPECT_EQ(labels_of(linear_axis({.low = 0.0, .high = 8.0, .tick_count = 4, .in_degrees = true})),
            Labels({"0", "2", "4", "6", "8"}));
}

TEST(Axes, HoldTheDemand) {
  for (const double size : {1e-12, 0.7, 3.0, 12345.6}) {
    const AxisRange axis = linear_axis({.low = -size, .high = 2.3 * size});
    EXPECT_LE(axis.low, -size);
    EXPECT_GE(axis.high, 2.3 * size);
    EXPECT_GE(axis.ticks.size(), 3U);
    EXPECT_LE(axis.ticks.size(), 12U);
  }
}

TEST(Axes, TakeLargePowersOfTenOutOfTheLabels) {
  const AxisRange axis = linear_axis({.low = 0.0, .high = 4e6, .tick_count = 4});

  EXPECT_EQ(axis.exponent, 6);
  EXPECT_EQ(labels_of(axis), Labels({"0", "1", "2", "3", "4"}));
}

TEST(Axes, HaveRoomAroundASingleValue) {
  const AxisRange of_zero = linear_axis({.low = 0.0, .high = 0.0});
  const AxisRange of_rounding = linear_axis({.low = 5.0, .high = 5.0 + 1e-13});

  EXPECT_LT(of_zero.low, 0.0);
  EXPECT_GT(of_zero.high, 0.0);
  EXPECT_LT(of_rounding.low, 4.0);
  EXPECT_GT(of_rounding.high, 6.0);
}

TEST(Axes, KeepTheEndsOfATightDemand) {
  const AxisRange axis = tight_axis({.low = 0.3, .high = 4.2, .tick_count = 4});

  EXPECT_EQ(axis.low, 0.3);
  EXPECT_EQ(axis.high, 4.2);
  EXPECT_EQ(labels_of(axis), Labels({"1", "2", "3", "4"}));
}

TEST(Axes, HaveWholeDecadesIfLogarithmic) {
  EXPECT_EQ(labels_of(logarithmic_axis({.low = 3e-3, .high = 40.0})),
            Labels({"10⁻³", "10⁻²", "10⁻¹", "1", "10¹", "10²"}));
}

TEST(Axes, LeaveOutDecadesWhereThereAreMany) {
  const AxisRange axis = logarithmic_axis({.low = 1e-31, .high = 1e-7, .tick_count = 6});

  EXPECT_LE(axis.ticks.size(), 7U);
  EXPECT_LE(axis.low, 1e-31 * (1 + 1e-12));
  EXPECT_GE(axis.high, 1e-7);
}

TEST(Axes, PlaceValuesByTheirLogarithm) {
  const AxisRange axis = logarithmic_axis({.low = 1.0, .high = 100.0});

  EXPECT_NEAR(axis.share(10.0), 0.5, 1e-15);
  EXPECT_TRUE(std::isnan(axis.share(0.0)));
  EXPECT_TRUE(std::isnan(axis.share(-1.0)));
}

TEST(Axes, HaveNoPlaceForWhatIsNotFinite) {
  const AxisRange axis = linear_axis({.low = 0.0, .high = 1.0});

  EXPECT_TRUE(std::isnan(axis.share(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(axis.share(std::numeric_limits<double>::quiet_NaN())));
}

TEST(Axes, LabelNumbersShortly) {
  EXPECT_EQ(label_number(2.846889952), "2.847");
  EXPECT_EQ(label_number(-2.0731707), "−2.073");
  EXPECT_EQ(label_number(100.0), "100");
  EXPECT_EQ(label_number(12345.6), "12346");
  EXPECT_EQ(label_number(0.00123456), "0.001235");
  EXPECT_EQ(label_number(1.5e-7), "1.5×10⁻⁷");
  EXPECT_EQ(label_number(-2.5e9), "−2.5×10⁹");
  EXPECT_EQ(label_number(0.0), "0");
  EXPECT_EQ(label_number(std::numeric_limits<double>::infinity()), "–");
}

TEST(Axes, RoundMantissasUpToTheNextDigit) {
  EXPECT_EQ(label_number(9.99999, 3), "10");
  EXPECT_EQ(label_number(999999.6, 4), "1000000");
}

}  // namespace
}  // namespace kinestat
