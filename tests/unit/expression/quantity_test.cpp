#include "expression/quantity.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(Quantity, KindsAreListedInTheOrderOfTheirEnumeration) {
  for (std::size_t i = 0; i < all_quantity_kinds().size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(all_quantity_kinds()[i]), i);
  }
}

TEST(Quantity, PowerIsForceTimesVelocity) {
  EXPECT_EQ(dimension_of(QuantityKind::power),
            dimension_of(QuantityKind::force) * dimension_of(QuantityKind::velocity));
}

TEST(Quantity, StiffnessIsForcePerLength) {
  EXPECT_EQ(dimension_of(QuantityKind::stiffness),
            dimension_of(QuantityKind::force) / dimension_of(QuantityKind::length));
}

TEST(Quantity, AngularStiffnessIsMomentPerAngle) {
  EXPECT_EQ(dimension_of(QuantityKind::angular_stiffness),
            dimension_of(QuantityKind::moment) / dimension_of(QuantityKind::angle));
}

TEST(Quantity, AccelerationIsLengthPerTimeSquared) {
  EXPECT_EQ(dimension_of(QuantityKind::acceleration),
            dimension_of(QuantityKind::length) / power(dimension_of(QuantityKind::time), 2));
}

TEST(Quantity, KnownDimensionIsNamedWithItsArticle) {
  EXPECT_EQ(phrase_of(Dimension{0, 0, -1, 1}), "an angular velocity");
}

TEST(Quantity, LengthIsNeverCalledALengthPerTurn) {
  EXPECT_EQ(phrase_of(Dimension{1, 0, 0, 0}), "a length");
}

TEST(Quantity, OtherDimensionIsSpelledInBaseUnits) {
  EXPECT_EQ(phrase_of(Dimension{2, 1, -1, 0}), "a quantity in kg*m^2/s");
}

TEST(Quantity, DimensionWithoutFactorsIsSpelledAsAQuotient) {
  EXPECT_EQ(phrase_of(Dimension{0, 0, -1, 0}), "a quantity in 1/s");
}

struct FitCase {
  const char* name;
  Dimension dimension;
  QuantityKind kind;
  bool expected;
};

class Fits : public testing::TestWithParam<FitCase> {};

TEST_P(Fits, IgnoresTheAngleOnlyWhereTheKindIsMoreThanAnAngle) {
  EXPECT_EQ(fits(GetParam().dimension, GetParam().kind), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Table,
    Fits,
    testing::Values(
        FitCase{"energy_per_radian_is_a_moment", {2, 1, -2, -1}, QuantityKind::moment, true},
        FitCase{"arc_is_a_length", {1, 0, 0, 1}, QuantityKind::length, true},
        FitCase{"torque_times_speed_is_a_power", {2, 1, -3, 1}, QuantityKind::power, true},
        FitCase{"length_is_a_pitch", {1, 0, 0, 0}, QuantityKind::pitch, true},
        FitCase{"length_per_radian_is_a_lead", {1, 0, 0, -1}, QuantityKind::lead, true},
        FitCase{"length_is_no_angle", {1, 0, 0, 0}, QuantityKind::angle, false},
        FitCase{"square_angle_is_no_angle", {0, 0, 0, 2}, QuantityKind::angle, false},
        FitCase{"angle_is_no_bare_number", {0, 0, 0, 1}, QuantityKind::dimensionless, false},
        FitCase{"angle_is_no_length", {0, 0, 0, 1}, QuantityKind::length, false},
        FitCase{"frequency_is_no_speed", {0, 0, -1, 0}, QuantityKind::angular_velocity, false},
        FitCase{"speed_is_a_speed", {0, 0, -1, 1}, QuantityKind::angular_velocity, true},
        FitCase{"force_is_no_moment", {1, 1, -2, 0}, QuantityKind::moment, false}),
    [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace kinestat
