#include "studies/synthesis/synthesis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "reference_tasks.hpp"
#include "support/angles.hpp"

namespace kinestat {
namespace {

std::vector<LinkageCandidate> linkages_of(const std::string& name, const LinkageLimits& limits) {
  const ReferenceTask& task = reference_task(name);
  return rank_linkages(solve_burmester(task.positions).dyads, task.positions, limits);
}

// Of the six four-bars of this task five can be driven through all positions, the best one with a
// margin of 58.63°; the reference says so for every drive.
TEST(Synthesis, RanksByTheMarginOfTheTransmissionAngle) {
  const auto found = linkages_of("IC01", {});

  ASSERT_EQ(found.size(), 6U);
  EXPECT_NEAR(found[0].margin(), 58.631093345885844 * kDegree, 2e-4);
  EXPECT_EQ(found[0].grashof->kind, GrashofClass::crank_rocker);
  EXPECT_NEAR(found[1].margin(), 26.186736474764142 * kDegree, 2e-4);
  EXPECT_NEAR(found[2].margin(), 10.509478964232049 * kDegree, 2e-4);
  EXPECT_NEAR(found[3].margin(), 8.815469848555356 * kDegree, 2e-4);
  EXPECT_EQ(found[4].defect(), Defect::branch);
}

TEST(Synthesis, NamesTheLimitThatALinkageMisses) {
  EXPECT_EQ(linkages_of("IC01", {.transmission = 30.0 * kDegree})[0].defect(), Defect::none);
  EXPECT_EQ(linkages_of("IC01", {.transmission = 30.0 * kDegree})[1].defect(),
            Defect::transmission);
  EXPECT_EQ(linkages_of("IC01", {.ratio = 1.01})[0].defect(), Defect::ratio);
  EXPECT_EQ(linkages_of("IC01", {.size = 0.1})[0].defect(), Defect::size);
}

// A crank-rocker transmits worst where the crank lies along the ground, beyond the positions or
// not: the cosine of the transmission angle is (b² + c² - (d ± a)²) / (2 b c) there.
TEST(Synthesis, LimitsTheTransmissionAngleOverTheWholeTurn) {
  const LinkageLimits fully{.classes = {GrashofClass::crank_rocker}, .turns_fully = true};
  const LinkageCandidate best = linkages_of("IC01", fully)[0];
  const FourBarLengths& all = *best.lengths;
  const double crank = std::min(all.crank_one, all.crank_other);
  const double rocker = std::max(all.crank_one, all.crank_other);
  const auto angle_at = [&](double diagonal) {
    return std::acos((all.coupler * all.coupler + rocker * rocker - diagonal * diagonal) /
                     (2.0 * all.coupler * rocker));
  };
  const double margin =
      std::min(angle_at(all.ground - crank), std::numbers::pi - angle_at(all.ground + crank));

  LinkageLimits limits = fully;
  limits.full_transmission = margin - 1e-6;
  EXPECT_EQ(linkages_of("IC01", limits)[0].defect(), Defect::none);
  limits.full_transmission = margin + 1e-6;
  EXPECT_EQ(linkages_of("IC01", limits)[0].defect(), Defect::full_transmission);
}

TEST(Synthesis, LooksAtLinkagesOfTheTypeOnly) {
  EXPECT_EQ(linkages_of("IC16", {}).size(), 6U);
  EXPECT_EQ(linkages_of("IC16", {.type = LinkageType::four_bar}).size(), 3U);
  EXPECT_EQ(linkages_of("IC16", {.type = LinkageType::slider_crank}).size(), 3U);
}

// The reference has a crank-rocker with its centres in (0, 0) and (4, 0.5).
TEST(Synthesis, NamesAClassThatIsNotAskedFor) {
  const auto found = linkages_of("IC01", {.classes = {GrashofClass::crank_rocker}});
  const auto others = linkages_of("IC01", {.classes = {GrashofClass::triple_rocker}});

  EXPECT_EQ(found[0].defect(), Defect::none);
  for (const LinkageCandidate& one : found) {
    if (one.grashof->kind != GrashofClass::crank_rocker) {
      EXPECT_LE(one.defect(), Defect::grashof);
      EXPECT_NE(one.defect(), Defect::none);
    }
  }
  for (const LinkageCandidate& one : others) {
    EXPECT_EQ(
        one.is_usable(),
        one.grashof->kind == GrashofClass::triple_rocker && one.best().passage != Passage::none);
  }
}

// The crank is driven then, whatever the rocker would transmit.
TEST(Synthesis, DrivesWhatTurnsFully) {
  const auto found =
      linkages_of("IC01", {.classes = {GrashofClass::crank_rocker}, .turns_fully = true});

  ASSERT_EQ(found[0].defect(), Defect::none);
  EXPECT_TRUE(found[0].best().turns_fully);
  EXPECT_LT(input_of(found[0].linkage, found[0].best_drive).length,
            output_of(found[0].linkage, found[0].best_drive).length);
  for (const LinkageCandidate& one : found) {
    EXPECT_TRUE(!one.is_usable() || one.best().turns_fully);
  }
}

TEST(Synthesis, KeepsPivotsInTheirAreas) {
  const auto everywhere = linkages_of("IC01", {});
  const PlaneArea area = PlaneArea::between({-0.5, -0.5}, {4.5, 1.0});

  const auto found = linkages_of("IC01", {.centre_points = area});

  int usable = 0;
  for (const LinkageCandidate& one : everywhere) {
    const bool is_inside = area.distance(one.linkage.one.centre_point) == 0.0 &&
                           area.distance(one.linkage.other.centre_point) == 0.0;
    usable += is_inside && one.is_usable() ? 1 : 0;
  }
  EXPECT_GT(usable, 0);
  EXPECT_EQ(std::ranges::count(found, Defect::none, &LinkageCandidate::defect), usable);
  EXPECT_GT(std::ranges::count(found, Defect::centre_point, &LinkageCandidate::defect), 0);
}

// The linkage of table 2 has its positions in two circuits.
TEST(Synthesis, NamesACircuitDefect) {
  const auto found = linkages_of("table2", {});

  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].defect(), Defect::circuit);
}

}  // namespace
}  // namespace kinestat
