#include <gtest/gtest.h>

#include "mechanism/check/section_checks.hpp"
#include "unit/mechanism/checked_text.hpp"

namespace kinestat {
namespace {

// A file that holds a task alone; the task begins in line 4.
Complaints complaints_about_task(const std::string& task) {
  return complaints_of(
      check_of("kinestat: 1\nunits: {length: mm, angle: deg}\nsynthesis:\n" + task));
}

TEST(SynthesisCheck, AcceptsEveryKey) {
  EXPECT_EQ(
      complaints_about_task("  positions:\n"
                            "    - {at: [0, 0], angle: [30, 0.5 rad], pole: [1, 2 cm],\n"
                            "       curvature: {centre: [3, 2.6], m: 0.58}, stationary: true}\n"
                            "    - {at: [1, 0], angle: 0}\n"
                            "  limits: {transmission_angle: 30, link_ratio: 12, size: 20}\n"
                            "  vary: {free_point: {from: [0, 1], to: [2, 3]}}\n"
                            "  curves: {count: 400}\n"),
      Complaints{});
}

TEST(SynthesisCheck, AcceptsDerivativesInRadians) {
  EXPECT_EQ(
      complaints_about_task("  positions:\n"
                            "    - {at: [0, 0], angle: 0, derivatives: [{at: [1, 0], angle: 1},\n"
                            "       {at: [0, 1], angle: 0}]}\n"),
      Complaints{});
}

TEST(SynthesisCheck, CountsPositionsWithTheirContacts) {
  EXPECT_EQ(complaints_about_task("  positions: [{at: [0, 0], angle: 0}]\n"),
            (Complaints{"3:1 E0305 the task P has 1 position; a dyad takes two to five"}));
  EXPECT_EQ(complaints_about_task("  positions:\n"
                                  "    - {at: [0, 0], angle: 0, pole: [1, 1]}\n"
                                  "    - {at: [0, 1], angle: 9, pole: [1, 1]}\n"
                                  "    - {at: [0, 2], angle: 8, pole: [1, 1]}\n"),
            (Complaints{"3:1 E0305 the task PP-PP-PP has 6 positions; a dyad takes two to five"}));
}

TEST(SynthesisCheck, WantsTheQuantitiesOfTheirPlaces) {
  EXPECT_EQ(complaints_about_task(
                "  positions:\n"
                "    - {at: [0, 1 deg], angle: 2 mm, pole: [1 s, 0],\n"
                "       curvature: {centre: [1, 1 N], free_point: [0, 1 rad], m: 2 mm}}\n"
                "    - {at: [0, 0], angle: 0, derivatives: [{at: [1, 2], angle: 30 mm}]}\n"),
            (Complaints{"5:16 E0309 expected a length, found an angle",
                        "5:31 E0309 expected an angle, found a length",
                        "5:44 E0309 expected a length, found a time",
                        "6:32 E0309 expected a length, found a force",
                        "6:54 E0309 expected a length, found an angle",
                        "6:65 E0309 expected a bare number, found a length",
                        "7:64 E0309 expected an angle, found a length"}));
}

TEST(SynthesisCheck, NeedsAFreePointAndMUnlessTheyVary) {
  EXPECT_EQ(complaints_about_task(
                "  positions:\n"
                "    - {at: [0, 0], angle: 0, pole: [1, 1], curvature: {centre: [1, 2]}}\n"),
            (Complaints{"5:55 E0303 'curvature' of position 1 lacks the key 'free_point'",
                        "5:55 E0303 'curvature' of position 1 lacks the key 'm'"}));
}

// Of five positions what both leave open may vary as a whole.
TEST(SynthesisCheck, OffersToVaryWhatCurvatureLeavesOpen) {
  EXPECT_EQ(
      complaints_about_task(
          "  positions:\n"
          "    - {at: [0, 0], angle: 0, pole: [1, 1], curvature: {centre: [1, 2]}}\n"
          "    - {at: [0, 1], angle: 9, pole: [1, 1]}\n"),
      (Complaints{"5:55 E0303 'curvature' of position 1 lacks the keys 'free_point' and 'm'"}));
}

TEST(SynthesisCheck, RefusesToVaryWhatNoPositionHas) {
  EXPECT_EQ(complaints_about_task("  positions: [{at: [0, 0], angle: 0}, {at: [1, 0], angle: 9}]\n"
                                  "  vary: {m: {from: 1, to: 2}}\n"),
            (Complaints{"5:10 E0313 'vary' names 'm', but no position has 'curvature'"}));
}

TEST(SynthesisCheck, WantsLimitsThatCanBe) {
  EXPECT_EQ(complaints_about_task("  positions: [{at: [0, 0], angle: 0}, {at: [1, 0], angle: 9}]\n"
                                  "  limits: {transmission_angle: 90, link_ratio: 0.9, size: 0}\n"
                                  "  curves: {count: 2.5}\n"),
            (Complaints{"5:32 E0305 'transmission_angle' of 'limits' cannot be 90",
                        "5:48 E0305 'link_ratio' of 'limits' cannot be 0.9",
                        "5:59 E0305 'size' of 'limits' cannot be 0",
                        "6:19 E0305 'count' of 'curves' cannot be 2.5"}));
}

TEST(SynthesisCheck, RefusesARatioOfZero) {
  EXPECT_EQ(
      complaints_about_task("  positions:\n"
                            "    - {at: [0, 0], angle: 0, pole: [1, 1],\n"
                            "       curvature: {centre: [1, 2], free_point: [2, 2], m: 0}}\n"),
      (Complaints{"6:59 E0305 'm' of position 1 cannot be 0"}));
}

}  // namespace
}  // namespace kinestat
