#include <gtest/gtest.h>

#include "format/sections/sections.hpp"
#include "support/read_section.hpp"

namespace kinestat {
namespace {

auto task_of(const std::string& text) {
  return read_section(synthesis_section(), "'synthesis'", text, Space::spatial);
}

TEST(SynthesisSection, ReadsTheSmallestTask) {
  const auto reading =
      task_of("positions: [{at: [0, 1], angle: 30 deg}, {at: [2, 3], angle: 0}]\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const SynthesisDescription& task = *reading.value;
  EXPECT_EQ(task.linkage, LinkageKind::four_bar);
  ASSERT_EQ(task.positions.size(), 2U);
  EXPECT_EQ(task.positions[0].angles[0].expression.text(), "30 deg");
  EXPECT_EQ(task.positions[0].order(), 1);
  EXPECT_FALSE(task.limits.size);
  EXPECT_FALSE(task.curve_count);
}

TEST(SynthesisSection, TakesCurvesWithoutACountForTheUsualOne) {
  const auto reading =
      task_of("positions: [{at: [0, 1], angle: 0}, {at: [2, 3], angle: 0}]\ncurves: {}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  EXPECT_EQ(reading.value->curve_count->expression.text(), "200");
}

TEST(SynthesisSection, ReadsEveryKey) {
  const auto reading = task_of(
      "linkage: slider_crank\n"
      "positions:\n"
      "  - {at: [0, 0], angle: [30 deg, 40 deg], pole: [1, 2],\n"
      "     curvature: {centre: [3, 2.6], free_point: [0.75, 2], m: 0.58},\n"
      "     stationary: true, burmester: true}\n"
      "limits: {transmission_angle: 30 deg, link_ratio: 12, size: 20}\n"
      "vary: {m: {from: 0.2, to: 3}, free_point: {from: [0, 1], to: [2, 3]}, "
      "samples: 100}\n"
      "digits: 40\n"
      "curves: {count: 400}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const SynthesisDescription& task = *reading.value;
  EXPECT_EQ(task.linkage, LinkageKind::slider_crank);
  const PositionDescription& position = task.positions[0];
  EXPECT_EQ(position.order(), 5);
  EXPECT_EQ(position.angles.size(), 2U);
  EXPECT_EQ(position.pole->coordinates[1].expression.text(), "2");
  EXPECT_EQ(position.curvature->centre.coordinates[1].expression.text(), "2.6");
  EXPECT_EQ(position.curvature->m->expression.text(), "0.58");
  EXPECT_EQ(task.limits.link_ratio->expression.text(), "12");
  ASSERT_EQ(task.vary.size(), 2U);
  EXPECT_EQ(task.vary[0].which, FreeNumber::m);
  EXPECT_EQ(task.vary[1].to[1].expression.text(), "3");
  EXPECT_EQ(task.samples->expression.text(), "100");
  EXPECT_EQ(task.digits->expression.text(), "40");
  EXPECT_EQ(task.curve_count->expression.text(), "400");
}

TEST(SynthesisSection, ReadsWhatMayBeFree) {
  const auto reading = task_of(
      "positions: [{at: [0, 0], angle: 0}]\n"
      "vary: {tau_2: {from: 1, to: 2}, tau: {from: 3, to: 4}, s: {from: 5, to: 6}}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const SynthesisDescription& task = *reading.value;
  ASSERT_EQ(task.vary.size(), 3U);
  EXPECT_EQ(task.vary[0].which, FreeNumber::s);
  EXPECT_EQ(task.vary[0].to[0].expression.text(), "6");
  EXPECT_EQ(task.vary[1].which, FreeNumber::tau);
  EXPECT_EQ(task.vary[2].which, FreeNumber::tau_2);
}

TEST(SynthesisSection, ReadsTheAreaOfCirclePoints) {
  const auto reading = task_of(
      "positions: [{at: [0, 0], angle: 0}]\n"
      "vary: {circle_points: {from: [1, 2], to: [3, 4]}}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  ASSERT_EQ(reading.value->vary.size(), 1U);
  EXPECT_EQ(reading.value->vary[0].which, FreeNumber::circle_points);
  EXPECT_EQ(reading.value->vary[0].to[1].expression.text(), "4");
}

TEST(SynthesisSection, RefusesRangesThatSayTheSame) {
  const auto complaints_of_vary = [](const std::string& ranges) {
    return task_of("positions: [{at: [0, 0], angle: 0}]\nvary: {" + ranges + "}\n").complaints();
  };
  EXPECT_EQ(complaints_of_vary("tau: {from: 3, to: 4}, m: {from: 5, to: 6}"),
            (Complaints{"2:8 E0302 'vary' cannot have 'tau' together with 'm' or 'free_point'"}));
  EXPECT_EQ(
      complaints_of_vary("s: {from: 3, to: 4}, circle_points: {from: [1, 2], to: [3, 4]}"),
      (Complaints{"2:29 E0302 'vary' cannot have 'circle_points' together with other ranges"}));
  EXPECT_EQ(complaints_of_vary("samples: 100"),
            (Complaints{"2:7 E0303 'vary' names nothing that is free"}));
}

TEST(SynthesisSection, ReadsDerivatives) {
  const auto reading = task_of(
      "positions: [{at: [0, 0], angle: 0, derivatives: [{at: [1, 0], angle: 1}, {at: [0, 2], "
      "angle: 0}]}]\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  EXPECT_EQ(reading.value->positions[0].order(), 3);
  EXPECT_EQ(reading.value->positions[0].derivatives[1].angle->expression.text(), "0");
}

TEST(SynthesisSection, NeedsPointAndAngle) {
  EXPECT_EQ(task_of("linkage: any\n").complaints(),
            (Complaints{"1:1 E0303 'synthesis' lacks the key 'positions'"}));
  EXPECT_EQ(task_of("positions: [{}, 3]\n").complaints(),
            (Complaints{"1:13 E0303 position 1 lacks the key 'at'",
                        "1:13 E0303 position 1 lacks the key 'angle'",
                        "1:17 E0304 position 2 must be a mapping of keys to values"}));
}

TEST(SynthesisSection, WantsEachOrderAfterTheOneBefore) {
  const auto reading = task_of(
      "positions:\n"
      "  - {at: [0, 0], angle: 0, curvature: {centre: [1, 1]}}\n"
      "  - {at: [0, 0], angle: 0, pole: [1, 1], stationary: true}\n"
      "  - {at: [0, 0], angle: 0, burmester: true}\n");

  EXPECT_EQ(reading.complaints(),
            (Complaints{"2:28 E0303 'curvature' of position 1 needs 'pole' too",
                        "3:42 E0303 'stationary' of position 2 needs 'curvature' too",
                        "4:28 E0303 'burmester' of position 3 needs 'stationary' too"}));
}

TEST(SynthesisSection, RefusesAnOrderThatTheOneBeforeDenies) {
  EXPECT_EQ(task_of("positions:\n"
                    "  - {at: [0, 0], angle: 0, pole: [1, 1], curvature: {centre: [1, 2]},\n"
                    "     stationary: false, burmester: true}\n")
                .complaints(),
            (Complaints{"3:25 E0303 'burmester' of position 1 needs 'stationary: true'"}));
}

TEST(SynthesisSection, RefusesAPoleBesideDerivatives) {
  EXPECT_EQ(task_of("positions:\n"
                    "  - {at: [0, 0], angle: 0, pole: [1, 1], derivatives: [{at: [1, 2]}]}\n")
                .complaints(),
            (Complaints{"2:28 E0302 position 1 cannot have 'pole' together with 'derivatives'"}));
}

TEST(SynthesisSection, WantsAnAngleInAllDerivativesOrInNone) {
  EXPECT_EQ(
      task_of("positions:\n"
              "  - {at: [0, 0], angle: 0, derivatives: [{at: [1, 2]}, {at: [1, 2], angle: 3}]}\n")
          .complaints(),
      (Complaints{"2:41 E0303 only some derivatives of position 1 have an 'angle'"}));
}

TEST(SynthesisSection, ReportsWrongShapesAtTheirPlaces) {
  EXPECT_EQ(task_of("linkage: fourbar\n"
                    "positions:\n"
                    "  - {at: [0, 0, 0], angle: [], pole: x, derivates: []}\n"
                    "limits: {angle: 3}\n"
                    "vary: {pole: {from: 1}, m: {from: 1}}\n"
                    "curves: 3\n")
                .complaints(),
            (Complaints{"1:10 E0305 'linkage' of 'synthesis' cannot be 'fourbar'",
                        "3:10 E0304 'at' of position 1 has 3 components, planar space needs 2",
                        "3:28 E0304 'angle' of position 1 must be a list with something in it",
                        "3:38 E0304 'pole' of position 1 has 1 component, planar space needs 2",
                        "3:41 E0302 position 1 has no key 'derivates'",
                        "4:10 E0302 'limits' of 'synthesis' has no key 'angle'",
                        "5:28 E0303 'm' of 'vary' lacks the key 'to'",
                        "5:8 E0302 'vary' of 'synthesis' has no key 'pole'",
                        "6:9 E0304 'curves' of 'synthesis' must be a mapping of keys to values"}));
}

}  // namespace
}  // namespace kinestat
