// A point lies at infinity where the positions cannot tell it from there.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "known_linkage.hpp"
#include "near_dyad.hpp"
#include "reference_tasks.hpp"
#include "studies/synthesis/dyads/burmester.hpp"
#include "studies/synthesis/dyads/internal/dyad_point.hpp"
#include "studies/synthesis/synthesis.hpp"

namespace kinestat {
namespace {

std::vector<PositionJets> shifted(std::vector<PositionJets> positions, double by) {
  for (PositionJets& position : positions) {
    position.x[0] += by;
    position.y[0] -= by;
  }
  return positions;
}

class FarOrigin : public testing::TestWithParam<double> {};

// Random slider-cranks and inverted ones in all groupings: rounding of the places by the distance
// of the origin must not turn a slider into a crank of a million sizes.
TEST_P(FarOrigin, LeavesSlidersSliders) {
  const std::vector<std::vector<int>> forms = {
      {5}, {4, 1}, {3, 2}, {3, 1, 1}, {2, 2, 1}, {2, 1, 1, 1}, {1, 1, 1, 1, 1}};
  Random random(17);
  int done = 0;
  for (int seed = 0; done < 140; ++seed) {
    SCOPED_TRACE(seed);
    const KnownLinkage linkage = random_linkage(
        random, DyadKind::crank, seed % 2 == 0 ? DyadKind::slider : DyadKind::inverted_slider);
    const auto positions =
        random_positions(random, linkage, forms[static_cast<std::size_t>(seed) % forms.size()]);
    if (positions.empty()) {
      continue;
    }
    ++done;

    const BurmesterSolution solution = solve_burmester(shifted(positions, GetParam()));

    Dyad known = linkage.other;
    known.centre_point += Point(GetParam(), -GetParam());
    if (solution.status != BurmesterStatus::solved) {
      EXPECT_EQ(solution.status, BurmesterStatus::no_digits);
      continue;
    }
    const Dyad found = nearest_dyad(solution.dyads, known);
    EXPECT_EQ(found.kind, known.kind);
    EXPECT_LT(distance(found, known), std::max(1e-13, std::pow(10.0, 1.0 - found.digits)));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Burmester, FarOrigin, testing::Values(0.0, 1e3, 1e5, 1e6, 1e7, 1e8), [](const auto& one) {
      return "By1e" + std::to_string(std::lround(one.param > 0.0 ? std::log10(one.param) : 0.0));
    });

// IC16: the slider of a slider-crank whose doubles are 1e7 sizes away from the origin, which leave
// it nine decimals.
TEST(FarPoint, IsThatOfTheSliderOfAFarTask) {
  const auto task = std::ranges::find(reference_tasks(), "IC16", &ReferenceTask::name);
  const std::vector<PositionJets> positions = shifted(task->positions, 1e7);

  const BurmesterSolution solution = solve_burmester(positions);
  const auto linkages =
      rank_linkages(solution.dyads, positions, {.type = LinkageType::slider_crank});

  ASSERT_EQ(solution.dyads.size(), 4U);
  EXPECT_EQ(solution.dyads[3].kind, DyadKind::slider);
  EXPECT_LT(std::abs(solution.dyads[3].circle_point - Point(2.7, 0.4)), 1e-6);
  EXPECT_LT(std::abs(cross(solution.dyads[3].direction, unit_vector(0.1))), 1e-6);
  EXPECT_EQ(linkages.size(), 3U);
}

// So far away that its long crank may be a slider as well: but not the one that is there already.
TEST(FarPoint, IsThatOfOneSliderOnly) {
  const auto task = std::ranges::find(reference_tasks(), "IC16", &ReferenceTask::name);

  const BurmesterSolution solution = solve_burmester(shifted(task->positions, 1e11));

  ASSERT_EQ(solution.dyads.size(), 4U);
  EXPECT_EQ(std::ranges::count(solution.dyads, DyadKind::slider, &Dyad::kind), 1);
}

// Positions of size 1 whose doubles leave an eighth: nearly the same, but not the same.
TEST(FarPoint, IsNoReasonToTakePositionsForTheSame) {
  const auto task = std::ranges::find(reference_tasks(), "IC16", &ReferenceTask::name);

  EXPECT_EQ(solve_burmester(shifted(task->positions, 1e15)).status, BurmesterStatus::no_digits);
}

double rounded_to(double value, double unit) {
  return std::round(value / unit) * unit;
}

std::vector<PositionJets> rounded_to(std::vector<PositionJets> positions, double unit) {
  for (PositionJets& position : positions) {
    position.x[0] = rounded_to(position.x[0], unit);
    position.y[0] = rounded_to(position.y[0], unit);
    position.angle[0] = rounded_to(position.angle[0], unit);
  }
  return positions;
}

class FewDecimals : public testing::TestWithParam<int> {};

// Positions rounded to some decimals have a crank of thousands of sizes instead of the slider; that
// they are rounded explains it.
TEST_P(FewDecimals, LeaveSlidersSliders) {
  const double unit = std::pow(10.0, -GetParam());
  Random random(18);
  int done = 0;
  int found_again = 0;
  for (int seed = 0; done < 100; ++seed) {
    SCOPED_TRACE(seed);
    const KnownLinkage linkage = random_linkage(
        random, DyadKind::crank, seed % 2 == 0 ? DyadKind::slider : DyadKind::inverted_slider);
    const auto positions = random_positions(random, linkage, {1, 1, 1, 1, 1});
    if (positions.empty()) {
      continue;
    }
    ++done;

    const BurmesterSolution solution =
        solve_burmester(rounded_to(positions, unit), {.length = unit / 2, .angle = unit / 2});

    const Dyad found = nearest_dyad(solution.dyads, linkage.other);
    found_again += found.kind == linkage.other.kind ? 1 : 0;
    if (found.crank_length > 0.0) {
      EXPECT_LT(distance(found, linkage.other), std::pow(10.0, 1.0 - found.digits));
      EXPECT_GT(found.deviation, 0.0);
      EXPECT_LT(found.deviation, 60.0 * unit);
    }
  }
  EXPECT_GT(found_again, GetParam() > 6 ? 95 : 70);
}

INSTANTIATE_TEST_SUITE_P(Burmester,
                         FewDecimals,
                         testing::Values(6, 8, 10, 12),
                         [](const auto& one) { return "By" + std::to_string(one.param); });

// A crank of 2000 sizes misses a straight line by some hundred-thousandths: eleven decimals show
// it, five do not.
TEST(FarPoint, IsNoneOfALongCrankWhoseArcTheDecimalsShow) {
  KnownLinkage linkage;
  linkage.one = {.circle_point = {0.3, -0.2}, .centre_point = {0.0, 0.0}, .length = 1.0};
  linkage.other = {.circle_point = {2.7, 0.4}, .centre_point = {3.0, 4000.0}, .length = 4000.0};
  std::vector<PositionJets> positions;
  for (const double angle : {-0.6, -0.45, -0.25, -0.1, 0.1}) {
    const std::vector<Point> origins = linkage.origins(angle);
    ASSERT_FALSE(origins.empty());
    positions.push_back(finite_position(origins.back(), angle));
  }

  const auto fine =
      solve_burmester(rounded_to(positions, 1e-11), {.length = 5e-12, .angle = 5e-12});
  const auto coarse = solve_burmester(positions, {.length = 5e-6, .angle = 5e-6});

  EXPECT_LT(nearest(fine.dyads, linkage.other), 1e-3);
  EXPECT_TRUE(std::ranges::any_of(coarse.dyads, [](const Dyad& dyad) {
    return dyad.kind == DyadKind::slider && dyad.crank_length > 0.0;
  }));
}

TEST(Ranking, HasLinkagesWithoutDigitsLastWhateverTheirMargin) {
  const auto task = std::ranges::find(reference_tasks(), "IC01", &ReferenceTask::name);
  std::vector<Dyad> dyads = solve_burmester(task->positions).dyads;
  const auto before = rank_linkages(dyads, task->positions, {});
  ASSERT_EQ(before[0].defect(), Defect::none);
  dyads[before[0].dyads[0]].digits = 0.0;

  const auto after = rank_linkages(dyads, task->positions, {});

  ASSERT_EQ(after.size(), before.size());
  const auto is_lost = [&](const LinkageCandidate& one) {
    return one.dyads[0] == before[0].dyads[0] || one.dyads[1] == before[0].dyads[0];
  };
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(is_lost(after[i]), i >= 3);
    EXPECT_EQ(after[i].defect() == Defect::digits, is_lost(after[i]));
  }
}

// A slider at (2, 0) along (0.8, -0.6), of positions so coarse that no condition tells the
// components of its direction from zero.
TEST(FarPoint, HasADirectionWhereNothingOfItIsSure) {
  Eigen::Matrix<double, 7, 1> x;
  x << 0.0, 0.0, 0.6, 0.8, 1.2, 1.6, 0.0;
  ConditionRows coarse;
  coarse.rows = {{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0}};
  coarse.noise = {1.0};
  PositionJets first;
  first.x = first.y = first.angle = {0.0};

  const std::optional<Dyad> dyad = dyad_of(x, coarse, first, 0.0);

  ASSERT_TRUE(dyad);
  ASSERT_EQ(dyad->kind, DyadKind::slider);
  EXPECT_NEAR(dyad->direction.real(), 0.8, 1e-15);
  EXPECT_NEAR(dyad->direction.imag(), -0.6, 1e-15);
}

}  // namespace
}  // namespace kinestat
