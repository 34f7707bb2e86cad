#include <gtest/gtest.h>

#include "format/sections/sections.hpp"
#include "support/read_section.hpp"

namespace kinestat {
namespace {

auto loads_of(const std::string& text, Space space = Space::planar) {
  return read_form(loads(), "'loads'", text, space);
}

TEST(LoadSection, ReadsAForceAtAPoint) {
  const auto reading = loads_of("wind: {body: rod, at: [1, 2], force: [3 N, -4]}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const LoadDescription& wind = (*reading.value)[0];
  EXPECT_EQ(wind.body.text, "rod");
  EXPECT_EQ(wind.at->coordinates[1].expression.text(), "2");
  EXPECT_EQ(wind.force->coordinates[0].expression.text(), "3 N");
  EXPECT_TRUE(wind.couple.empty());
}

TEST(LoadSection, ReadsACoupleAsOneNumberInThePlane) {
  const auto reading = loads_of("brake: {body: rod, couple: 5 N*m}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  ASSERT_EQ((*reading.value)[0].couple.size(), 1U);
  EXPECT_EQ((*reading.value)[0].couple[0].expression.text(), "5 N*m");
}

TEST(LoadSection, ReadsACoupleAsAVectorInSpace) {
  const auto reading = loads_of(
      "all: {body: rod, at: [0, 0, 0], force: [1, 2, 3], couple: [4, 5, 6]}\n", Space::spatial);

  ASSERT_EQ(reading.complaints(), Complaints{});
  EXPECT_EQ((*reading.value)[0].couple.size(), 3U);
}

TEST(LoadSection, RefusesTheCoupleOfTheOtherSpace) {
  EXPECT_EQ(loads_of("a: {body: rod, couple: [0, 0, 5]}\n").complaints(),
            (Complaints{"1:24 E0304 'couple' of load 'a' is one number about z in planar space"}));
  EXPECT_EQ(loads_of("a: {body: rod, couple: 5}\n", Space::spatial).complaints(),
            (Complaints{"1:24 E0304 'couple' of load 'a' has 1 component, spatial space needs 3"}));
}

TEST(LoadSection, NeedsABodyAndAnAction) {
  EXPECT_EQ(loads_of("a: {}\n").complaints(),
            (Complaints{"1:1 E0303 load 'a' lacks the key 'body'",
                        "1:1 E0303 load 'a' has neither 'force' nor 'couple'"}));
}

TEST(LoadSection, NeedsThePointOfAForce) {
  EXPECT_EQ(loads_of("a: {body: rod, force: [1, 0]}\n").complaints(),
            (Complaints{"1:16 E0303 the force of load 'a' has no point where it acts"}));
}

TEST(LoadSection, RefusesThePointOfACouple) {
  EXPECT_EQ(loads_of("a: {body: rod, at: [0, 0], couple: 1}\n").complaints(),
            (Complaints{"1:16 E0302 load 'a' has 'at' but no force that acts there"}));
}

TEST(LoadSection, TurnsWithItsBodyOnlyWhereTheFileSaysSo) {
  const auto reading = loads_of(
      "a: {body: rod, couple: 1}\nb: {body: rod, couple: 1, frame: body}\n"
      "c: {body: rod, couple: 1, frame: world}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  EXPECT_EQ((*reading.value)[0].frame, LoadFrame::world);
  EXPECT_EQ((*reading.value)[1].frame, LoadFrame::body);
  EXPECT_EQ((*reading.value)[2].frame, LoadFrame::world);
}

TEST(LoadSection, ReportsEveryUnknownKey) {
  EXPECT_EQ(
      loads_of("a: {bdy: rod, couple: 1}\nb: {body: rod, couple: 1, moment: 2}\n").complaints(),
      (Complaints{"1:5 E0302 load 'a' has no key 'bdy'",
                  "2:27 E0302 load 'b' has no key 'moment'"}));
}

}  // namespace
}  // namespace kinestat
