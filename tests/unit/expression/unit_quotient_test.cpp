#include "expression/unit_quotient.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(UnitQuotient, HasOneStroke) {
  EXPECT_EQ(unit_quotient("N*m", "mm"), "N*m/mm");
  EXPECT_EQ(unit_quotient("N", "kg*mm"), "N/(kg*mm)");
  EXPECT_EQ(unit_quotient("rpm", "mm/s"), "rpm*s/mm");
  EXPECT_EQ(unit_quotient("N/mm", "kg/s"), "N*s/(mm*kg)");
  EXPECT_EQ(unit_quotient("N/(rad/s)", "mm"), "N*s/(rad*mm)");
}

TEST(UnitQuotient, CancelsWhatIsAboveAndBelow) {
  EXPECT_EQ(unit_quotient("rad/s", "mm/s"), "rad/mm");
  EXPECT_EQ(unit_quotient("N*m", "N*m"), "");
  EXPECT_EQ(unit_quotient("N", "N/mm"), "mm");
  EXPECT_EQ(unit_quotient("N", "N*m"), "1/m");
  EXPECT_EQ(unit_quotient("kg*mm^2", "mm"), "kg*mm");
  EXPECT_EQ(unit_quotient("mm/s", "mm^2"), "1/(mm*s)");
  EXPECT_EQ(unit_quotient("mm", "mm/s^2"), "s^2");
}

TEST(UnitQuotient, IsOfPlainNumbersToo) {
  EXPECT_EQ(unit_quotient("", "mm"), "1/mm");
  EXPECT_EQ(unit_quotient("m/s", ""), "m/s");
  EXPECT_EQ(unit_quotient("", ""), "");
  EXPECT_EQ(unit_quotient("1/mm", "1/mm"), "");
}

// Units of other names stay apart: they are not converted.
TEST(UnitQuotient, ConvertsNothing) {
  EXPECT_EQ(unit_quotient("deg/s", "rad/s"), "deg/rad");
  EXPECT_EQ(unit_quotient("mm", "m"), "mm/m");
}

}  // namespace
}  // namespace kinestat
