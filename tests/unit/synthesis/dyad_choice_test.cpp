#include "studies/synthesis/dyads/dyad_choice.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "reference_tasks.hpp"

namespace kinestat {
namespace {

const ChoiceArea kArea{.from = {-3.0, -2.0}, .to = {4.0, 3.0}};

std::vector<PositionJets> some_positions(std::size_t count) {
  const std::vector<PositionJets>& all = reference_tasks()[0].positions;
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
}

CandidateMaker linkages_of(const DyadChoice& choice, const LinkageLimits& limits) {
  return [&choice, limits](std::span<const double> numbers) {
    return choice.candidate(numbers, limits);
  };
}

TEST(DyadChoice, OfFourPositionsFollowsTheCurve) {
  const DyadChoice choice(some_positions(4), kArea);

  for (int i = 0; i <= 50; ++i) {
    const std::vector<double> numbers = {i / 50.0, 1.0 - i / 50.0};
    for (const Dyad& dyad : choice.dyads(numbers)) {
      EXPECT_LT(dyad.residual, 1e-11) << i;
      EXPECT_GT(dyad.circle_point.real(), kArea.from.real() - 0.1);
      EXPECT_LT(dyad.circle_point.imag(), kArea.to.imag() + 0.1);
    }
  }
}

// A crank-rocker leads the plane through these positions with a margin of the transmission angle:
// its pins (0.3, -0.2) and (3.59, 1.00) lie in the area, so that a selection finds one not worse.
TEST(DyadChoice, OfFourPositionsFindsALinkageAtLeastAsGoodAsTheKnownOne) {
  const std::vector<PositionJets> positions = some_positions(4);
  const std::vector<Dyad> known = {
      *find_dyad(positions, pose_of(positions[0]).place({0.3, -0.2})),
      *find_dyad(positions, pose_of(positions[0]).place({3.5878044949658263, 1.0001423260940798}))};
  const LinkageCandidate reference = rank_linkages(known, positions, {})[0];
  ASSERT_EQ(reference.defect(), Defect::none);
  const DyadChoice choice(positions, kArea);

  const Selection found =
      select_linkages(choice.ranges(4000), linkages_of(choice, {.ratio = 12.0, .size = 20.0}), 3);

  ASSERT_FALSE(found.best.empty());
  const LinkageCandidate& best = found.best[0].candidate;
  EXPECT_GE(best.margin(), reference.margin());
  EXPECT_LE(best.ratio, 12.0);
  EXPECT_LE(best.longest, 20.0);
  EXPECT_LT(find_residual(best.linkage.one, positions), 1e-11);
  EXPECT_LT(find_residual(best.linkage.other, positions), 1e-11);
}

TEST(DyadChoice, OfThreePositionsTakesAnyPair) {
  const std::vector<PositionJets> positions = some_positions(3);
  const DyadChoice choice(positions, kArea);

  const std::vector<Dyad> dyads = choice.dyads(std::vector{0.3, -0.2, -1.0, 2.0});

  ASSERT_EQ(dyads.size(), 2U);
  EXPECT_LT(std::abs(dyads[0].circle_point - Point(0.3, -0.2)), 1e-14);
  EXPECT_LT(std::abs(dyads[0].centre_point), 1e-14);  // the crank that the positions come from
  EXPECT_LT(std::abs(dyads[1].circle_point - Point(-1.0, 2.0)), 1e-14);
  EXPECT_LT(dyads[1].residual, 1e-13);
}

TEST(DyadChoice, OfThreePositionsKeepsToTheArea) {
  const DyadChoice choice(some_positions(3), kArea);

  const Selection found =
      select_linkages(choice.ranges(2000), linkages_of(choice, {.ratio = 8.0}), 2);

  ASSERT_FALSE(found.best.empty());
  for (const Dyad* dyad :
       {&found.best[0].candidate.linkage.one, &found.best[0].candidate.linkage.other}) {
    EXPECT_GE(dyad->circle_point.real(), kArea.from.real() - 1e-12);
    EXPECT_LE(dyad->circle_point.real(), kArea.to.real() + 1e-12);
    EXPECT_LT(dyad->residual, 1e-12);
  }
}

TEST(DyadChoice, OfThreePositionsMayChooseTheCentres) {
  const DyadChoice choice(some_positions(3),
                          {.from = {-3.0, -2.0}, .to = {4.0, 3.0}, .of = DyadPoint::centre_point});

  const std::vector<Dyad> dyads = choice.dyads(std::vector{0.0, 0.0, 4.0, 0.5});

  ASSERT_EQ(dyads.size(), 2U);
  EXPECT_LT(std::abs(dyads[0].circle_point - Point(0.3, -0.2)), 1e-13);
  EXPECT_LT(std::abs(dyads[1].centre_point - Point(4.0, 0.5)), 1e-13);
  EXPECT_LT(dyads[1].residual, 1e-13);
}

TEST(DyadChoice, OfFourPositionsFollowsTheCurveOfCentres) {
  const std::vector<PositionJets> positions = some_positions(4);
  const DyadChoice choice(positions,
                          {.from = {-3.0, -2.0}, .to = {5.0, 3.0}, .of = DyadPoint::centre_point});
  const PlaneCubic curve = find_curves(positions).centre_points;

  for (int i = 0; i <= 50; ++i) {
    const std::vector<double> numbers = {i / 50.0, 1.0 - i / 50.0};
    for (const Dyad& dyad : choice.dyads(numbers)) {
      EXPECT_LT(dyad.residual, 1e-11) << i;
      EXPECT_LT(curve.miss(dyad.centre_point), 1e-12) << i;
    }
  }
}

TEST(DyadChoice, LeavesTheGivenDyadAsItIs) {
  const std::vector<PositionJets> positions = some_positions(3);
  const Dyad given = *find_dyad(positions, {0.0, 0.0}, DyadPoint::centre_point);
  const DyadChoice choice(positions, kArea, given);

  const std::vector<SelectionRange> ranges = choice.ranges(400);
  const std::vector<Dyad> dyads = choice.dyads(std::vector{-1.0, 2.0});

  ASSERT_EQ(ranges.size(), 2U);
  EXPECT_EQ(ranges[0].count, 20);
  ASSERT_EQ(dyads.size(), 2U);
  EXPECT_EQ(dyads[0].circle_point, given.circle_point);
  EXPECT_LT(std::abs(dyads[1].circle_point - Point(-1.0, 2.0)), 1e-14);
}

TEST(DyadChoice, HasNoRangesWhereTheCurveIsElsewhere) {
  const DyadChoice choice(some_positions(4), {.from = {1000.0, 1000.0}, .to = {1000.1, 1000.1}});

  EXPECT_TRUE(choice.ranges(4000).empty());
}

}  // namespace
}  // namespace kinestat
