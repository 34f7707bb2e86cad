#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/angles.hpp"
#include "unit/motion/moving.hpp"

namespace kinestat {
namespace {

// Crank 1 and ground 3; the rocker pin is drawn to the left of the diagonal.
std::string four_bar(double coupler, double rocker, double angle) {
  const Vec3 b(std::cos(angle), std::sin(angle), 0.0);
  const Vec3 diagonal = Vec3(3.0, 0.0, 0.0) - b;
  const double length = diagonal.norm();
  const double along = (length * length + coupler * coupler - rocker * rocker) / (2.0 * length);
  const double height = std::sqrt(coupler * coupler - along * along);
  const Vec3 u = diagonal / length;
  const Vec3 c = b + along * u + height * Vec3(-u.y(), u.x(), 0.0);
  return fmt::format(
      "space: planar\nground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
      "  a: {{type: revolute, bodies: [frame, crank], at: [0, 0]}}\n"
      "  b: {{type: revolute, bodies: [crank, coupler], at: [{}, {}]}}\n"
      "  c: {{type: revolute, bodies: [coupler, rocker], at: [{}, {}]}}\n"
      "  d: {{type: revolute, bodies: [frame, rocker], at: [3, 0]}}\n",
      b.x(),
      b.y(),
      c.x(),
      c.y());
}

// Which side of the diagonal the rocker pin is on.
double side(const Moving& subject, const MotionSolution& solution, int k) {
  const auto poses = body_poses(subject.network, solution.configuration_at(k));
  const auto& points = subject.mechanism.geometry.points;
  const Vec3 b = poses[1].point(points[1]);
  const Vec3 c = poses[2].point(points[2]);
  const Vec3 d = points[3];
  return (d - b).cross(c - b).z();
}

class Parallelogram : public testing::TestWithParam<int> {};

// All links come in line at 0 and 180 deg; the rocker goes on turning with the crank, whether or
// not a step ends exactly there.
TEST_P(Parallelogram, PassesItsChangePoints) {
  const double start = kPi / 3.0;
  const Moving subject = moving(four_bar(3.0, 1.0, start), {"a.wz"});

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, GetParam());

  ASSERT_EQ(solution.status, MotionStatus::completed);
  for (int k = 0; k < solution.position_count(); ++k) {
    EXPECT_NEAR(
        subject.position(solution.configuration_at(k), "d.wz"), solution.drive_value(0, k), 1e-9);
  }
  std::vector<double> places;
  for (const SpecialPosition& one : solution.special) {
    EXPECT_EQ(one.kind, SpecialKind::change_point);
    places.push_back(one.drive_values.at(0));
  }
  ASSERT_EQ(places.size(), 2U);
  EXPECT_NEAR(places[0], kPi - start, 1e-8);
  EXPECT_NEAR(places[1], 2.0 * kPi - start, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Steps, Parallelogram, testing::Values(12, 100, 360));

// The other branch of the same links: the rocker turns against the crank.
TEST(Branch, OfTheAntiparallelogramIsKeptToo) {
  const double start = kPi / 3.0;
  // The crossed pin is that of the parallelogram reflected in the diagonal.
  const Vec3 b(std::cos(start), std::sin(start), 0.0);
  const Vec3 u = (Vec3(3.0, 0.0, 0.0) - b).normalized();
  const Vec3 open = b + Vec3(3.0, 0.0, 0.0);
  const Vec3 crossed = b + 2.0 * u.dot(open - b) * u - (open - b);
  const Moving subject = moving(
      fmt::format("space: planar\nground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
                  "  a: {{type: revolute, bodies: [frame, crank], at: [0, 0]}}\n"
                  "  b: {{type: revolute, bodies: [crank, coupler], at: [{}, {}]}}\n"
                  "  c: {{type: revolute, bodies: [coupler, rocker], at: [{}, {}]}}\n"
                  "  d: {{type: revolute, bodies: [frame, rocker], at: [3, 0]}}\n",
                  b.x(),
                  b.y(),
                  crossed.x(),
                  crossed.y()),
      {"a.wz"});

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 90);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_LE(worst_closure_error(solution), 1e-12);
  EXPECT_NEAR(subject.position(solution.configuration_at(90), "d.wz"), -2.0 * kPi, 1e-9);
}

struct Loops {
  double excess = 0.0;  ///< of the couplings over the ground
  double turn = 0.0;    ///< from the one loop to the other
  double to = 0.0;
  int steps = 0;

  friend void PrintTo(const Loops& loops, std::ostream* out) {
    *out << loops.excess << " by " << loops.turn << " in " << loops.steps;
  }
};

class TwoLoops : public testing::TestWithParam<Loops> {};

// Two near parallelograms on one crank, with couplings that are too long to pass the dead centre:
// before it both turn back at once, whatever lies behind. There the end of the crank stands as far
// from the pivot of the rocker as the coupler is longer than the rocker.
TEST_P(TwoLoops, EndWhereBothTurnBack) {
  const double start = -78.0 * kDegree;
  const double crank = 0.9538;
  const double coupler = 1.0 + GetParam().excess;
  const auto loop = [&](double turn, std::string_view name) {
    const Vec3 b(crank * std::cos(start), crank * std::sin(start), 0.0);
    const Vec3 diagonal = Vec3(1.0, 0.0, 0.0) - b;
    const double length = diagonal.norm();
    const double along = (length * length + coupler * coupler - crank * crank) / (2.0 * length);
    const double height = std::sqrt(coupler * coupler - along * along);
    const Vec3 u = diagonal / length;
    const Vec3 c = b + along * u + height * Vec3(-u.y(), u.x(), 0.0);
    const auto turned = [&](const Vec3& p) {
      return fmt::format("[{}, {}]",
                         p.x() * std::cos(turn) - p.y() * std::sin(turn),
                         p.x() * std::sin(turn) + p.y() * std::cos(turn));
    };
    return fmt::format(
        "  b{0}: {{type: revolute, bodies: [crank, coupler{0}], at: {1}}}\n"
        "  c{0}: {{type: revolute, bodies: [coupler{0}, rocker{0}], at: {2}}}\n"
        "  d{0}: {{type: revolute, bodies: [frame, rocker{0}], at: {3}}}\n",
        name,
        turned(b),
        turned(c),
        turned(Vec3(1.0, 0.0, 0.0)));
  };
  const Moving subject = moving(
      "space: planar\nground: frame\n"
      "bodies: [crank, coupler1, rocker1, coupler2, rocker2]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}\n" +
          loop(0.0, "1") + loop(GetParam().turn, "2"),
      {"a.wz"});
  const double distance = coupler - crank;
  const double limit =
      -start - std::acos((1.0 + crank * crank - distance * distance) / (2.0 * crank));

  const MotionSolution solution = move(subject, 0.0, GetParam().to, GetParam().steps);

  ASSERT_EQ(solution.status, MotionStatus::limit);
  ASSERT_EQ(solution.special.size(), 1U);
  EXPECT_EQ(solution.special.back().kind, SpecialKind::limit);
  EXPECT_NEAR(solution.special.back().drive_values.at(0), limit, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Steps,
                         TwoLoops,
                         testing::Values(Loops{3e-7, kPi, 170.0 * kDegree, 72},
                                         Loops{1e-3, kPi, 170.0 * kDegree, 72},
                                         Loops{1e-7, 13.0 * kDegree, 4.0 * kPi, 10},
                                         Loops{1e-5, 13.0 * kDegree, 4.0 * kPi, 10},
                                         Loops{1e-3, 13.0 * kDegree, 4.0 * kPi, 10},
                                         Loops{1e-2, 13.0 * kDegree, 4.0 * kPi, 10}));

class Neck : public testing::TestWithParam<double> {};

// Longer or shorter than the parallelogram by little, the two branches come near each other without
// meeting: the pin stays on its side of the diagonal (fault 76).
TEST_P(Neck, IsNotJumped) {
  const Moving subject = moving(four_bar(3.0 + GetParam(), 1.0 + 2.0 * GetParam(), 1.0), {"a.wz"});

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 60);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_LE(worst_closure_error(solution), 1e-12);
  for (int k = 0; k < solution.position_count(); ++k) {
    EXPECT_GT(side(subject, solution, k), 0.0) << k;
  }
  for (const SpecialPosition& one : solution.special) {
    EXPECT_NE(one.kind, SpecialKind::change_point);
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, Neck, testing::Values(1e-2, 1e-3, 1e-4, 1e-6));

// A crank of this turn, with its pin in the frame's x-axis at the origin; the rocker pin is on the
// side `sign` of the diagonal.
Moving linkage(const std::array<double, 4>& links, double angle, double sign) {
  const auto [crank, coupler, rocker, ground] = links;
  const Vec3 b = crank * Vec3(std::cos(angle), std::sin(angle), 0.0);
  const Vec3 diagonal = Vec3(ground, 0.0, 0.0) - b;
  const double length = diagonal.norm();
  const double along = (length * length + coupler * coupler - rocker * rocker) / (2.0 * length);
  const double height = sign * std::sqrt(coupler * coupler - along * along);
  const Vec3 u = diagonal / length;
  const Vec3 c = b + along * u + height * Vec3(-u.y(), u.x(), 0.0);
  return moving(
      fmt::format("space: planar\nground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
                  "  a: {{type: revolute, bodies: [frame, crank], at: [0, 0]}}\n"
                  "  b: {{type: revolute, bodies: [crank, coupler], at: [{}, {}]}}\n"
                  "  c: {{type: revolute, bodies: [coupler, rocker], at: [{}, {}]}}\n"
                  "  d: {{type: revolute, bodies: [frame, rocker], at: [{}, 0]}}\n",
                  b.x(),
                  b.y(),
                  c.x(),
                  c.y(),
                  ground),
      {"a.wz"});
}

struct Stop {
  std::array<double, 4> links;  // crank, coupler, rocker, ground
  double angle = 0.0;           // of the crank as drawn [deg]
  double sign = 1.0;
  double to = 0.0;  // [deg]
  int steps = 0;
};

class NearlyAChangePoint : public testing::TestWithParam<Stop> {};

// Where coupler and rocker cannot reach quite far enough, the crank turns back, although another
// branch begins a little further on.
TEST_P(NearlyAChangePoint, IsALimit) {
  const auto [links, angle, sign, to, steps] = GetParam();
  const auto [crank, coupler, rocker, ground] = links;
  const double start = angle * kPi / 180.0;
  const Moving subject = linkage(links, start, sign);

  const MotionSolution solution = move(subject, 0.0, to * kPi / 180.0, steps);

  // The nearest angle, in the sense of the motion, at which the diagonal has one of two lengths.
  double expected = 2.0 * kPi;
  for (const double diagonal : {coupler + rocker, std::abs(coupler - rocker)}) {
    const double cosine =
        (crank * crank + ground * ground - diagonal * diagonal) / (2.0 * crank * ground);
    for (const double side : {1.0, -1.0}) {
      const double turn = std::copysign(1.0, to) * (side * std::acos(cosine) - start);
      const double way = turn - 2.0 * kPi * std::floor(turn / (2.0 * kPi));
      expected = std::isnan(way) ? expected : std::min(expected, way);
    }
  }
  ASSERT_EQ(solution.status, MotionStatus::limit);
  ASSERT_EQ(solution.special.size(), 1U);
  EXPECT_NEAR(std::abs(solution.special[0].drive_values[0]), expected, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Linkages,
    NearlyAChangePoint,
    testing::Values(
        Stop{{1.8827060208507826, 1.500246167613572, 0.6877853953475789, 2.6951657931167756},
             40.03999030795064,
             1.0,
             -360.0,
             12},
        Stop{{3.472573231608499, 2.171224728292365, 2.7089180140467723, 1.4075705107306378},
             73.97469277227404,
             1.0,
             -360.0,
             72},
        Stop{{0.7377277044695806, 4.649292730516089, 0.3185671409545868, 5.068452294031084},
             287.7796598523404,
             1.0,
             720.0,
             12},
        Stop{{0.26198978999203726, 0.7214218541995635, 0.3110461138216887, 0.7704781790292148},
             307.65887932257726,
             -1.0,
             -360.0,
             360}));

class BesideAChangePoint : public testing::TestWithParam<double> {};

// Links 1, 3, 4 and 6 come in line at 180 deg, wherever a step ends.
TEST_P(BesideAChangePoint, AStepMayEnd) {
  const double start = GetParam();
  const Moving subject = linkage({1.0, 3.0, 4.0, 6.0}, start, 1.0);

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 72);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  ASSERT_EQ(solution.special.size(), 1U);
  EXPECT_NEAR(solution.special[0].drive_values[0], kPi - start, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Starts,
                         BesideAChangePoint,
                         testing::Values(1e-2, 1e-4, 1e-6, 1e-8, 1e-10, -1e-4, -1e-6, -1e-8));

// Forward and backward ends where it began, whichever way the drive goes first.
TEST(Branch, LeadsBack) {
  const Moving subject = moving(four_bar(3.2, 1.9, 0.4), {"a.wz"});

  const MotionSolution forth = move(subject, 0.0, 2.5, 50);
  const MotionSolution back = move(subject, 2.5, 0.0, 50);

  ASSERT_EQ(forth.status, MotionStatus::completed);
  ASSERT_EQ(back.status, MotionStatus::completed);
  for (int k = 0; k <= 50; ++k) {
    const auto a = forth.configuration_at(k).coordinates;
    const auto b = back.configuration_at(50 - k).coordinates;
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_NEAR(a[i], b[i], 1e-12);
    }
  }
}

// Drawn at another position of the same motion, the linkage takes the same path.
TEST(Branch, DoesNotDependOnWhereItIsDrawn) {
  const Moving here = moving(four_bar(3.2, 1.9, 0.4), {"a.wz"});
  const Moving there = moving(four_bar(3.2, 1.9, 1.4), {"a.wz"});

  const MotionSolution first = move(here, 1.0, 3.0, 40);
  const MotionSolution second = move(there, 0.0, 2.0, 40);

  for (int k = 0; k <= 40; ++k) {
    const Vec3 a = point_at(here, first, k, here.body("rocker"), here.mechanism.geometry.points[2]);
    const Vec3 b =
        point_at(there, second, k, there.body("rocker"), there.mechanism.geometry.points[2]);
    EXPECT_LE((a - b).norm(), 1e-12) << k;
  }
}

}  // namespace
}  // namespace kinestat
