#include "studies/synthesis/linkages/linkage.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "reference_four_bars.hpp"
#include "reference_tasks.hpp"
#include "studies/synthesis/linkages/cognates.hpp"
#include "studies/synthesis/linkages/verdict.hpp"
#include "support/angles.hpp"

namespace kinestat {
namespace {

const ReferenceTask& task_of(const ReferenceFourBar& four_bar) {
  return *std::ranges::find(reference_tasks(), four_bar.task, &ReferenceTask::name);
}

Linkage linkage_of(const ReferenceFourBar& four_bar) {
  const ReferenceTask& task = task_of(four_bar);
  Linkage linkage{.one = task.dyads[four_bar.one], .other = task.dyads[four_bar.other]};
  const Pose pose = pose_of(task.positions[0]);
  for (Dyad* dyad : {&linkage.one, &linkage.other}) {
    dyad->length = std::abs(pose.place(dyad->circle_point) - dyad->centre_point);
  }
  return linkage;
}

std::string text_of(const Grashof& grashof) {
  static const char* const kShort[] = {"ground", "crank1", "coupler", "crank2"};
  switch (grashof.kind) {
    case GrashofClass::crank_rocker:
      return grashof.which == FourBarLink::crank_one ? "Grashof crank-rocker (crank at dyad 1)"
                                                     : "Grashof crank-rocker (crank at dyad 2)";
    case GrashofClass::double_crank:
      return "Grashof double-crank (drag link)";
    case GrashofClass::double_rocker:
      return "Grashof double-rocker";
    case GrashofClass::triple_rocker:
      return std::string("non-Grashof triple-rocker (longest=") +
             kShort[static_cast<int>(grashof.which)] + ")";
    case GrashofClass::change_point:
      return "change point";
  }
  return "";
}

class ReferenceFourBars : public testing::TestWithParam<ReferenceFourBar> {};

TEST_P(ReferenceFourBars, HaveTheirLengths) {
  const FourBarLengths& expected = GetParam().lengths;

  const FourBarLengths found = *lengths_of(linkage_of(GetParam()));

  EXPECT_NEAR(found.ground, expected.ground, 1e-13 * expected.longest());
  EXPECT_NEAR(found.crank_one, expected.crank_one, 1e-13 * expected.longest());
  EXPECT_NEAR(found.coupler, expected.coupler, 1e-13 * expected.longest());
  EXPECT_NEAR(found.crank_other, expected.crank_other, 1e-13 * expected.longest());
  EXPECT_EQ(text_of(classify(found)), GetParam().grashof);
}

TEST_P(ReferenceFourBars, HaveTheirVerdicts) {
  for (std::size_t i = 0; i < 2; ++i) {
    SCOPED_TRACE(i);
    const ReferenceDrive& expected = GetParam().drives[i];

    const DriveVerdict found = find_verdict(
        linkage_of(GetParam()), i == 0 ? Drive::one : Drive::other, task_of(GetParam()).positions);

    EXPECT_EQ(found.same_circuit, expected.same_circuit);
    EXPECT_EQ(found.same_circuit && found.same_branch, expected.same_branch);
    EXPECT_EQ(found.same_circuit && found.same_branch && found.passage != Passage::none,
              !expected.working_arc.empty());
    EXPECT_EQ(found.turns_fully, expected.turns_fully);
    for (std::size_t j = 0; j < expected.angles.size(); ++j) {
      const double turn =
          std::remainder(found.coordinates[j] - expected.angles[j] * kDegree, 360.0 * kDegree);
      EXPECT_NEAR(turn, 0.0, 1e-12);
      EXPECT_NEAR(found.transmission[j], expected.transmission[j] * kDegree, 1e-12);
    }
  }
}

TEST_P(ReferenceFourBars, HaveTheirWorkingArc) {
  for (std::size_t i = 0; i < 2; ++i) {
    const ReferenceDrive& expected = GetParam().drives[i];
    if (expected.working_arc.empty()) {
      continue;
    }
    const DriveVerdict found = find_verdict(
        linkage_of(GetParam()), i == 0 ? Drive::one : Drive::other, task_of(GetParam()).positions);

    // The reference scans the arc in steps: it stays inside, and comes near an extreme only.
    constexpr double kRounding = 1e-12;
    constexpr double kScan = 2e-4;
    ASSERT_TRUE(found.working_arc);
    const double least = expected.working_arc[0] * kDegree;
    const double most = expected.working_arc[1] * kDegree;
    EXPECT_LE(found.working_arc->least, least + kRounding);
    EXPECT_GE(found.working_arc->least, least - kScan);
    EXPECT_GE(found.working_arc->most, most - kRounding);
    EXPECT_LE(found.working_arc->most, most + kScan);
  }
}

TEST_P(ReferenceFourBars, HaveTheirCognates) {
  const Linkage linkage = linkage_of(GetParam());
  const Pose pose = pose_of(task_of(GetParam()).positions[0]);

  const auto found = find_cognates(linkage, pose, {0.0, 0.0});

  if (std::abs(linkage.one.circle_point) == 0.0 || std::abs(linkage.other.circle_point) == 0.0) {
    EXPECT_FALSE(found);
    return;
  }
  ASSERT_TRUE(found);
  EXPECT_LT(std::abs(found->third_pivot - GetParam().third_pivot),
            1e-12 * std::max(std::abs(GetParam().third_pivot), 1.0));
}

INSTANTIATE_TEST_SUITE_P(Synthesis,
                         ReferenceFourBars,
                         testing::ValuesIn(reference_four_bars()),
                         [](const auto& one) {
                           return one.param.task + "_" + std::to_string(one.param.one) + "_" +
                                  std::to_string(one.param.other);
                         });

TEST(Grashof, OfEqualSumsIsAChangePoint) {
  const Grashof found =
      classify({.ground = 3.0, .crank_one = 1.0, .coupler = 3.0, .crank_other = 1.0});

  EXPECT_EQ(found.kind, GrashofClass::change_point);
}

}  // namespace
}  // namespace kinestat
