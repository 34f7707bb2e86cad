#include "expression/file_units.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(FileUnits, DefaultTextsAreSi) {
  using enum QuantityKind;
  const FileUnits units;

  EXPECT_EQ(units.text(length), "m");
  EXPECT_EQ(units.text(moment), "N*m");
  EXPECT_EQ(units.text(velocity), "m/s");
  EXPECT_EQ(units.text(angular_velocity), "rad/s");
  EXPECT_EQ(units.text(acceleration), "m/s^2");
  EXPECT_EQ(units.text(dimensionless), "");
}

TEST(FileUnits, DefaultFactorsAreOne) {
  const FileUnits units;

  for (const QuantityKind kind : all_quantity_kinds()) {
    EXPECT_EQ(units.factor(kind), 1.0) << name_of(kind);
  }
}

TEST(FileUnits, VelocityFollowsLengthAndTime) {
  using enum QuantityKind;
  FileUnits units;

  units.set(length, "mm");
  units.set(QuantityKind::time, "min");

  EXPECT_EQ(units.text(velocity), "mm/min");
  EXPECT_DOUBLE_EQ(units.factor(velocity), 1e-3 / 60);
}

TEST(FileUnits, AccelerationDividesByTheTimeTwice) {
  using enum QuantityKind;
  FileUnits units;

  units.set(QuantityKind::time, "min");

  EXPECT_EQ(units.text(acceleration), "m/min^2");
  EXPECT_DOUBLE_EQ(units.factor(acceleration), 1.0 / 3600);
}

TEST(FileUnits, VelocityThatWasSetStays) {
  using enum QuantityKind;
  FileUnits units;

  units.set(velocity, "km/h");
  units.set(length, "mm");

  EXPECT_EQ(units.text(velocity), "km/h");
  EXPECT_DOUBLE_EQ(units.factor(velocity), 1000.0 / 3600);
}

TEST(FileUnits, AngularVelocityDoesNotFollowTheAngle) {
  using enum QuantityKind;
  FileUnits units;

  units.set(angle, "deg");

  EXPECT_EQ(units.text(angular_velocity), "rad/s");
  EXPECT_EQ(units.factor(angular_velocity), 1.0);
}

TEST(FileUnits, PitchAndLeadFollowTheLength) {
  using enum QuantityKind;
  FileUnits units;

  units.set(length, "mm");

  EXPECT_EQ(units.text(pitch), "mm/rad");
  EXPECT_EQ(units.text(lead), "mm/rev");
  EXPECT_DOUBLE_EQ(units.factor(lead), 1e-3);
}

TEST(FileUnits, AngularStiffnessFollowsTheMoment) {
  using enum QuantityKind;
  FileUnits units;

  units.set(moment, "N*mm");

  EXPECT_EQ(units.text(angular_stiffness), "N*mm/rad");
  EXPECT_DOUBLE_EQ(units.factor(angular_stiffness), 1e-3);
}

TEST(FileUnits, FromSiGivesTheFilesNumber) {
  using enum QuantityKind;
  FileUnits units;

  units.set(angle, "deg");

  EXPECT_DOUBLE_EQ(units.from_si(angle, std::numbers::pi), 180.0);
}

TEST(FileUnits, UnitOfAnotherDimensionIsRefused) {
  using enum QuantityKind;
  FileUnits units;

  const auto error = units.set(length, "deg");

  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->code, "E0309");
  EXPECT_EQ(error->message, "'deg' measures an angle, not a length");
}

TEST(FileUnits, RefusedUnitChangesNothing) {
  using enum QuantityKind;
  FileUnits units;

  units.set(length, "deg");

  EXPECT_EQ(units.text(length), "m");
}

TEST(FileUnits, TextThatIsNoUnitIsRefused) {
  using enum QuantityKind;
  FileUnits units;

  const auto error = units.set(length, "MM");

  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->code, "E0308");
}

TEST(FileUnits, AngularVelocityNeedsAnAngle) {
  using enum QuantityKind;
  FileUnits units;

  EXPECT_TRUE(units.set(angular_velocity, "1/s").has_value());
}

}  // namespace
}  // namespace kinestat
