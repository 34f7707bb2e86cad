#include "studies/synthesis/dyads/burmester.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "near_dyad.hpp"
#include "reference_tasks.hpp"
#include "support/random.hpp"

namespace kinestat {
namespace {

class ReferenceDyads : public testing::TestWithParam<ReferenceTask> {};

TEST_P(ReferenceDyads, AreFound) {
  const ReferenceTask& task = GetParam();

  const BurmesterSolution solution = solve_burmester(task.positions);

  EXPECT_EQ(solution.status, BurmesterStatus::solved);
  EXPECT_EQ(solution.imaginary_count, task.imaginary_count);
  EXPECT_EQ(solution.dyads.size(), task.dyads.size());
  for (const Dyad& expected : task.dyads) {
    EXPECT_LT(nearest(solution.dyads, expected), task.tolerance)
        << expected.circle_point << ' ' << expected.centre_point;
  }
  for (const Dyad& dyad : solution.dyads) {
    EXPECT_LT(dyad.residual, 1e-13);
  }
}

INSTANTIATE_TEST_SUITE_P(Burmester,
                         ReferenceDyads,
                         testing::ValuesIn(reference_tasks()),
                         [](const auto& one) { return one.param.name; });

// A four-bar with A0 in the origin, or beside it on x: A0A = 1, B0 = (3, 0), B0B = 2.5, AB = 2.8.
// The coupler stands at an angle to which the crank follows by the law of cosines.
TEST(Burmester, TellsACentreBesideTheOriginFromOneInIt) {
  const auto centre_of = [](double x) {
    std::vector<PositionJets> positions;
    for (const double crank : {0.4, 1.3, 2.2, 3.1, 4.0}) {
      const Point a = Point(x, 0.0) + unit_vector(crank);
      const Point to_b0 = Point(3.0, 0.0) - a;
      const double distance = std::abs(to_b0);
      const double away =
          std::acos((distance * distance + 2.8 * 2.8 - 2.5 * 2.5) / (2.0 * distance * 2.8));
      positions.push_back(finite_position(a, std::arg(to_b0) + away));
    }
    const BurmesterSolution solution = solve_burmester(positions);
    return std::ranges::min(solution.dyads,
                            {},
                            [](const Dyad& dyad) {
                              return std::abs(dyad.circle_point) + std::abs(dyad.centre_point);
                            })
        .centre_point;
  };

  EXPECT_EQ(centre_of(0.0), Point(0.0, 0.0));
  EXPECT_NEAR(centre_of(5e-13).real(), 5e-13, 5e-14);
}

// A crank-rocker whose crank moves by a millionth of a radian from position to position.
TEST(Burmester, RefusesPositionsThatAreTooClose) {
  const std::vector<PositionJets> positions = {
      finite_position({0.581552593014371, 0.38368212248895894}, 0.4721943757718849),
      finite_position({0.5815522648964023, 0.3836831816929242}, 0.4721940420713529),
      finite_position({0.5815519367775317, 0.38368424089652325}, 0.4721937083708755),
      finite_position({0.5815516086577589, 0.38368530009975604}, 0.47219337467045275),
      finite_position({0.581551280537084, 0.3836863593026226}, 0.47219304097008463)};

  EXPECT_EQ(solve_burmester(positions).status, BurmesterStatus::no_digits);
}

// Positions of the plane whose points (1, 0) and (-1, 0) slide on the axes: its origin, one of
// them, on x, and the angle -φ with its place 2 cos φ. The midpoint of the two turns about the
// crossing of the axes, and all points of the circle about it through them move on lines.
TEST(Burmester, FindsTheCrankOfATrammelBesideItsStraightPaths) {
  std::vector<PositionJets> positions;
  for (const double angle : {0.1745, 0.6981, 1.3090, 1.9199, 2.7925}) {
    positions.push_back(finite_position({2.0 * std::cos(angle), 0.0}, -angle));
  }

  const BurmesterSolution solution = solve_burmester(positions);

  EXPECT_EQ(solution.status, BurmesterStatus::family);
  EXPECT_EQ(solution.reason, Degeneracy::straight_paths);
  ASSERT_EQ(solution.dyads.size(), 1U);
  EXPECT_LT(std::abs(solution.dyads[0].circle_point - Point(-1.0, 0.0)), 1e-12);
  EXPECT_LT(std::abs(solution.dyads[0].centre_point), 1e-12);
  EXPECT_NEAR(solution.dyads[0].length, 1.0, 1e-12);
}

// The inversion of the trammel: the plane that carries the axes.
TEST(Burmester, FindsTheCrankOfAnInvertedTrammelBesideItsSlidingLines) {
  std::vector<PositionJets> positions;
  for (const double angle : {0.1745, 0.6981, 1.3090, 1.9199, 2.7925}) {
    positions.push_back(finite_position(-2.0 * std::cos(angle) * unit_vector(angle), angle));
  }

  const BurmesterSolution solution = solve_burmester(positions);

  EXPECT_EQ(solution.reason, Degeneracy::sliding_lines);
  ASSERT_EQ(solution.dyads.size(), 1U);
  EXPECT_LT(std::abs(solution.dyads[0].circle_point), 1e-12);
  EXPECT_LT(std::abs(solution.dyads[0].centre_point - Point(-1.0, 0.0)), 1e-12);
}

// The coupler of a parallelogram only translates: every point is a circle point.
TEST(Burmester, ReportsTranslationsAsAFamily) {
  std::vector<PositionJets> positions;
  for (const double degrees : {20.0, 60.0, 110.0, 200.0, 300.0}) {
    positions.push_back(finite_position(unit_vector(degrees * 0.017453292519943295), 0.0));
  }

  const BurmesterSolution solution = solve_burmester(positions);

  EXPECT_EQ(solution.status, BurmesterStatus::family);
  EXPECT_EQ(solution.reason, Degeneracy::parallelogram);
}

TEST(Burmester, ReportsARepeatedPositionAsAFamily) {
  std::vector<PositionJets> positions = reference_tasks()[0].positions;
  positions[4] = positions[0];

  EXPECT_EQ(solve_burmester(positions).reason, Degeneracy::repeated_position);
}

TEST(Burmester, ReportsAPositionThatRepeatsALaterOne) {
  std::vector<PositionJets> positions = reference_tasks()[0].positions;
  positions[4] = positions[2];

  const BurmesterSolution solution = solve_burmester(positions);

  EXPECT_EQ(solution.status, BurmesterStatus::family);
  EXPECT_EQ(solution.reason, Degeneracy::repeated_position);
}

// A whole turn more is the same pose, whichever position repeats the other.
TEST(Burmester, ReportsAPositionThatIsRepeatedAWholeTurnLater) {
  for (const double turns : {-1.0, 1.0, 2.0}) {
    SCOPED_TRACE(turns);
    std::vector<PositionJets> first = reference_tasks()[0].positions;
    first[4] = first[0];
    first[4].angle[0] += turns * 2.0 * std::numbers::pi;
    std::vector<PositionJets> later = reference_tasks()[0].positions;
    later[4] = later[2];
    later[4].angle[0] += turns * 2.0 * std::numbers::pi;

    EXPECT_EQ(solve_burmester(first).reason, Degeneracy::repeated_position);
    EXPECT_EQ(solve_burmester(later).reason, Degeneracy::repeated_position);
  }
}

TEST(Burmester, KeepsItsDyadsWhereAPositionIsTurnedByWholeTurns) {
  for (const ReferenceTask& task : reference_tasks()) {
    SCOPED_TRACE(task.name);
    std::vector<PositionJets> positions = task.positions;
    positions.back().angle[0] += 4.0 * std::numbers::pi;
    const BurmesterSolution before = solve_burmester(task.positions);

    const BurmesterSolution after = solve_burmester(positions);

    ASSERT_EQ(after.dyads.size(), before.dyads.size());
    for (const Dyad& dyad : before.dyads) {
      const Dyad found = nearest_dyad(after.dyads, dyad);
      const double allowed = std::pow(10.0, 1.0 - std::min(dyad.digits, found.digits));
      EXPECT_LT(distance(found, dyad), std::max(allowed, 1e-13));
    }
  }
}

std::vector<PositionJets> between(const std::vector<PositionJets>& one,
                                  const std::vector<PositionJets>& other,
                                  double share) {
  std::vector<PositionJets> result = one;
  for (std::size_t i = 0; i < one.size(); ++i) {
    result[i].x[0] += share * (other[i].x[0] - one[i].x[0]);
    result[i].y[0] += share * (other[i].y[0] - one[i].y[0]);
    result[i].angle[0] += share * (other[i].angle[0] - one[i].angle[0]);
  }
  return result;
}

// On the way from a task with four real dyads to one with two, two dyads meet in a double one.
TEST(Burmester, MergesTwoDyadsThatMeet) {
  const std::vector<PositionJets> four = reference_tasks()[0].positions;
  std::vector<PositionJets> two = four;
  two[2].x[0] += 3.0;
  ASSERT_EQ(solve_burmester(four).imaginary_count, 0);
  ASSERT_EQ(solve_burmester(two).imaginary_count, 2);
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (solve_burmester(between(four, two, middle)).imaginary_count == 0 ? low : high) = middle;
  }

  const BurmesterSolution solution = solve_burmester(between(four, two, low));

  const auto twofold = std::ranges::find(solution.dyads, 2, &Dyad::multiplicity);
  ASSERT_NE(twofold, solution.dyads.end());
  EXPECT_EQ(solution.dyads.size(), 3U);
  EXPECT_LT(twofold->residual, 1e-10);
}

std::vector<PositionJets> random_task(Random& random) {
  std::vector<PositionJets> positions;
  for (int i = 0; i < 5; ++i) {
    const double x = random.between(-2.0, 2.0);
    const double y = random.between(-2.0, 2.0);
    positions.push_back(finite_position({x, y}, random.between(-3.0, 3.0)));
  }
  return positions;
}

// On the way from a task with two real dyads to one without any, the last two meet; just beyond,
// the nearest dyad is still there, though others may miss the positions less.
TEST(Burmester, HasTheDyadsThatMetLastForTheNearestOne) {
  Random random(5);
  int done = 0;
  for (int seed = 0; done < 60; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<PositionJets> one = random_task(random);
    const std::vector<PositionJets> other = random_task(random);
    if (solve_burmester(one).imaginary_count != 2 || solve_burmester(other).imaginary_count != 4) {
      continue;
    }
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (solve_burmester(between(one, other, middle)).imaginary_count < 4 ? low : high) = middle;
    }
    const BurmesterSolution before = solve_burmester(between(one, other, low));
    const BurmesterSolution after = solve_burmester(between(one, other, high + 1e-3));
    if (before.imaginary_count != 2 || after.imaginary_count != 4 ||
        before.dyads[0].kind != DyadKind::crank) {
      continue;
    }
    ++done;

    ASSERT_TRUE(after.nearest);
    EXPECT_LT(distance(*after.nearest, before.dyads[0]), 0.3 * (1.0 + before.dyads[0].length));
  }
}

}  // namespace
}  // namespace kinestat
