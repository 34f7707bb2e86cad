#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "studies/sweep/motion/lane_motions.hpp"
#include "studies/sweep/task/sweep_samples.hpp"
#include "unit/run/swept_file.hpp"
#include "unit/run/swept_rows.hpp"

namespace kinestat {
namespace {

// Links r, k, o and the frame g_1, the crank drawn at the angle phi from it.
constexpr const char* kCrankRocker = R"(
kinestat: 1
space: planar
parameters:
  g_1: 6
  r: 2
  k: 5
  o: 5
  phi: 10 deg
  bx: r*cos(phi)
  by: r*sin(phi)
  q: (g_1 - bx)^2 + by^2
  t_1: (k^2 - o^2 + q)/(2*q)
  u: sqrt(k^2/q - t_1^2)
ground: frame
bodies: [crank, coupler, rocker]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [bx, by]}
  c: {type: revolute, bodies: [coupler, rocker],
      at: [bx + t_1*(g_1 - bx) + u*by, by - t_1*by + u*(g_1 - bx)]}
  d: {type: revolute, bodies: [frame, rocker], at: [g_1, 0]}
actuators: {motor: {coupling: a}, load: {coupling: d}}
cases:
  turn: {motion: {motor: 1 rad/s}, input: motor, output: load}
motion: {drive: motor, from: -20 deg, to: 340 deg, steps: 72, case: turn}
)";

constexpr const char* kSliderCrank = R"(
kinestat: 1
space: planar
parameters: {r: 2, l: 5, e: 0.5, phi: 30 deg}
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0], axis: -z}
  b: {type: revolute, bodies: [rod, crank], at: [r*cos(phi), r*sin(phi)]}
  c: {type: revolute, bodies: [rod, slider],
      at: [r*cos(phi) + sqrt(l^2 - (e - r*sin(phi))^2), e]}
  s: {type: prismatic, bodies: [frame, slider],
      at: [r*cos(phi) + sqrt(l^2 - (e - r*sin(phi))^2), e], axis: x}
actuators: {motor: {coupling: a}, ram: {coupling: s}}
cases:
  turn: {motion: {motor: 1 rad/s}, input: motor, output: ram}
motion: {drive: motor, to: 360 deg, steps: 60, case: turn}
)";

// Whose rocker drives a second one.
constexpr const char* kSixBar = R"(
kinestat: 1
space: planar
parameters: {x: 0, y: 0}
ground: frame
bodies: [crank, coupler, rocker, link, last]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [x, y]}
  b: {type: revolute, bodies: [crank, coupler], at: [20, 20]}
  c: {type: revolute, bodies: [coupler, rocker], at: [90, 60]}
  d: {type: revolute, bodies: [frame, rocker], at: [100, 0]}
  e: {type: revolute, bodies: [rocker, link], at: [120, 40]}
  f: {type: revolute, bodies: [link, last], at: [180, 70]}
  g: {type: revolute, bodies: [frame, last], at: [200, 0]}
actuators: {motor: {coupling: a}, load: {coupling: g}}
cases:
  turn: {motion: {motor: 1 rad/s}, input: motor, output: load}
motion: {drive: motor, to: 360 deg, steps: 90, case: turn}
)";

// As the last, and near u = 1 the last link turns back three times within two degrees of the crank.
constexpr const char* kHesitatingSixBar = R"(
kinestat: 1
space: planar
parameters: {u: 0}
ground: frame
bodies: [crank, coupler, rocker, link, last]
couplings:
  a: {type: revolute, bodies: [crank, frame], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [18.006 - 1.088*u, 18.877 + 0.340*u]}
  c: {type: revolute, bodies: [coupler, rocker], at: [86.689 - 0.521*u, 85.624 - 1.271*u]}
  d: {type: revolute, bodies: [frame, rocker], at: [88.215 - 0.108*u, 25.528 + 1.372*u]}
  e: {type: revolute, bodies: [link, rocker], at: [122.006 + 0.347*u, 55.360 - 0.102*u]}
  f: {type: revolute, bodies: [link, last], at: [182.307 - 0.349*u, 102.598 + 1.693*u]}
  g: {type: revolute, bodies: [frame, last], at: [219.620 - 0.197*u, -0.294 + 0.486*u]}
actuators: {motor: {coupling: a}, load: {coupling: g}}
cases:
  turn: {motion: {motor: 1 rad/s}, input: motor, output: load}
motion: {drive: motor, to: 467 deg, steps: 90, case: turn}
)";

// Likewise, near 84.3, 85.1 and 86 degrees: between two of these its rate is hardly above zero.
constexpr const char* kRestingSixBar = R"(
kinestat: 1
space: planar
parameters: {x: 40.672}
ground: frame
bodies: [crank, coupler, rocker, link, last]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [x, -47.735]}
  c: {type: revolute, bodies: [coupler, rocker], at: [42.598, 59.089]}
  d: {type: revolute, bodies: [frame, rocker], at: [114.199, 21.156]}
  e: {type: revolute, bodies: [rocker, link], at: [107.677, 102.3]}
  f: {type: revolute, bodies: [link, last], at: [203.568, 121.957]}
  g: {type: revolute, bodies: [frame, last], at: [194.693, 15.746]}
actuators: {motor: {coupling: a}, load: {coupling: g}}
cases:
  turn: {motion: {motor: 1 rad/s}, input: motor, output: load}
motion: {drive: motor, from: 0 deg, to: 720 deg, steps: 16, case: turn}
)";

/// How many states the lanes answer themselves.
std::size_t followed_states(SweepTask& task) {
  auto lanes = LaneMotions::make(
      task.description, task.mechanism, *task.motion, varying_parameters(task.plan));
  if (!lanes) {
    return 0;
  }
  SweepRow row{.values = std::vector<double>(task.columns.size())};
  StateWalk walk(task.plan, 0, task.plan.state_count());
  std::size_t count = 0;
  while (walk.next()) {
    if (!walk.is_undefined() && lanes->load(0, walk.slots())) {
      lanes->follow();
      count += lanes->fill(0, task.columns, row) ? 1 : 0;
    }
  }
  return count;
}

// In every state the lanes say what the whole motion says; `least` is the share of the states that
// they answer at least.
void expect_whole_motions(const char* text, const char* sweep, double least) {
  SweptFile file(text, sweep);
  SweepTask& task = file.task();
  const std::vector<Row> lanes = rows_of(task, kLanes);
  const std::vector<Row> whole = rows_of(task, 1);
  expect_near(lanes, whole);
  const auto solved =
      static_cast<double>(std::ranges::count(whole, std::string("solved"), &Row::status));
  EXPECT_GE(static_cast<double>(followed_states(task)), least * solved);
  EXPECT_GT(solved, 0.0);
}

TEST(SweptMotions, OfFourBarsAreThoseOfWholeMotions) {
  expect_whole_motions(kCrankRocker,
                       "{vary: {r: {from: 0.6, to: 3, step: 0.3}, k: {from: 3, to: 7, step: 0.8}, "
                       "o: {from: 2.5, to: 6.5, step: 0.8}, phi: [10 deg, 200 deg]}, "
                       "report: [d.wz.position.range, transmission_angle.least, "
                       "transmission_angle.greatest, c.wz.position.least, dead_points]}",
                       0.98);
}

TEST(SweptMotions, OfSliderCranksAreThoseOfWholeMotions) {
  expect_whole_motions(kSliderCrank,
                       "{vary: {r: {from: 0.5, to: 3, step: 0.25}, l: {from: 2, to: 6, step: 0.5}, "
                       "e: [-1.5, -0.5, 0, 1], phi: [30 deg, -100 deg]}, "
                       "report: [s.vx.position.range, s.vx.position.mean, b.wz.position.peak, "
                       "c.wz.position.greatest, transmission_angle.least, s.vx.dead_points]}",
                       0.98);
}

TEST(SweptMotions, OfSixBarsAreThoseOfWholeMotions) {
  expect_whole_motions(kSixBar,
                       "{vary: {x: {from: -8, to: 8, step: 1}, y: {from: -8, to: 8, step: 2}}, "
                       "report: [g.wz.position.range, f.wz.position.least, "
                       "transmission_angle.least, dead_points]}",
                       0.75);
}

// Next to change points the coupler swings fast, and what is predicted of it is far off.
TEST(SweptMotions, OfFastCouplersAreThoseOfWholeMotions) {
  expect_whole_motions(
      kCrankRocker,
      "{vary: {r: {from: 0.5, to: 2.5, step: 0.1}, k: {from: 4, to: 8, step: 0.5}, "
      "o: {from: 4, to: 8, step: 0.5}}, "
      "require: ['r + 2*max(g_1, k, o) + 0.3 < g_1 + k + o'], "
      "report: [d.wz.position.range, transmission_angle.least, "
      "c.wz.position.greatest, dead_points]}",
      1.0);
}

// Crank and coupler, stretched or folded, make a triangle of 3, 8 or 5, 7 and 8 with the frame: its
// angle of 60 degrees is a step of the motion.
TEST(SweptMotions, FindDeadPointsOnSteps) {
  for (const char* links : {"g_1: [5], r: [1], k: [7], o: [7]",
                            "g_1: [8], r: [1], k: [4], o: [7]",
                            "g_1: [8], r: [2], k: [7], o: [7]"}) {
    expect_whole_motions(kCrankRocker,
                         fmt::format("{{vary: {{{}}}, report: [d.wz.position.range, "
                                     "d.wz.position.least, d.wz.position.greatest, dead_points]}}",
                                     links)
                             .c_str(),
                         1.0);
  }
}

// A crank-rocker has two dead points a turn, at which crank and coupler are stretched or folded:
// the rocker swings between the angles that the law of cosines gives there. One step takes all
// turns.
TEST(SweptMotions, LoseNoDeadPointsInLongSteps) {
  constexpr double kFrame = 6.0;
  constexpr double kCoupler = 5.0;
  constexpr double kRocker = 5.0;
  std::string text = kCrankRocker;
  text.replace(text.find("to: 340 deg, steps: 72"), 22, "to: 1060 deg, steps: 1");
  SweptFile file(text.c_str(),
                 "{vary: {r: {from: 0.5, to: 3, step: 0.1}, phi: [10 deg, 200 deg]}, "
                 "report: [dead_points, d.wz.position.range]}");
  const std::vector<Row> rows = rows_of(file.task(), kLanes);
  EXPECT_EQ(rows.size(), 52U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double crank = 0.5 + 0.1 * static_cast<double>(i / 2);
    const auto angle = [&](double reach) {
      return std::acos((kFrame * kFrame + kRocker * kRocker - reach * reach) /
                       (2.0 * kFrame * kRocker));
    };
    EXPECT_EQ(rows[i].values[0], 6.0) << i;
    EXPECT_NEAR(rows[i].values[1], angle(kCoupler + crank) - angle(kCoupler - crank), 1e-12) << i;
  }
  EXPECT_EQ(followed_states(file.task()), rows.size());
}

TEST(SweptMotions, LoseNoDeadPointsThatLieNearEachOther) {
  for (const int steps : {1, 5, 12, 180}) {
    std::string text = kHesitatingSixBar;
    text.replace(text.find("steps: 90"), 9, fmt::format("steps: {}", steps));
    expect_whole_motions(text.c_str(),
                         "{vary: {u: {from: 0, to: 1.5, step: 0.05}}, "
                         "report: [g.wz.position.range, d.wz.position.least, dead_points]}",
                         0.9);
  }
}

// Between long steps, wherever they fall, of every extreme that no dead point shows.
TEST(SweptMotions, ClimbToTheExtremesOfWholeMotions) {
  for (const int steps : {2, 3, 7, 16, 41}) {
    SCOPED_TRACE(steps);
    std::string text = kCrankRocker;
    text.replace(text.find("steps: 72"), 9, fmt::format("steps: {}", steps));
    expect_whole_motions(
        text.c_str(),
        "{vary: {r: {from: 0.7, to: 2.8, step: 0.7}, k: {from: 4, to: 7, step: 1}, "
        "o: {from: 3, to: 6, step: 1}, phi: [10 deg, 77 deg, 200 deg]}, "
        "report: [c.wz.position.range, transmission_angle.least, "
        "b.wz.position.peak, transmission_angle.greatest]}",
        0.97);
  }
}

TEST(SweptMotions, ClimbWithoutDeadPoints) {
  std::string text = kSixBar;
  text.replace(text.find("steps: 90"), 9, "steps: 20");
  expect_whole_motions(text.c_str(),
                       "{vary: {x: {from: -8, to: 8, step: 1}, y: {from: -8, to: 8, step: 4}}, "
                       "report: [transmission_angle.least, transmission_angle.range]}",
                       0.7);
}

// The angle between coupler and rocker is extreme where crank and frame are in line; folded, it is
// greatest at a right angle if it passes one, and least at one of the two.
TEST(SweptMotions, FindExtremesOfTransmissionBetweenLongSteps) {
  constexpr double kFrame = 6.0;
  constexpr double kCoupler = 5.0;
  std::string text = kCrankRocker;
  text.replace(text.find("steps: 72"), 9, "steps: 25");
  SweptFile file(text.c_str(),
                 "{vary: {r: {from: 0.5, to: 2.5, step: 0.25}, o: [4, 5, 6.5], "
                 "phi: [10 deg, 95 deg]}, report: [transmission_angle.least, "
                 "transmission_angle.greatest, c.wz.position.range]}");
  const std::vector<Row> rows = rows_of(file.task(), kLanes);
  EXPECT_EQ(rows.size(), 54U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double crank = 0.5 + 0.25 * static_cast<double>(i / 6);
    const double rocker = std::array{4.0, 5.0, 6.5}[i / 2 % 3];
    const auto angle = [&](double reach) {
      return std::acos((kCoupler * kCoupler + rocker * rocker - reach * reach) /
                       (2.0 * kCoupler * rocker));
    };
    const double narrow = angle(kFrame - crank);
    const double wide = angle(kFrame + crank);
    const double right = std::acos(0.0);
    const bool passes = narrow < right && wide > right;
    const double least = std::min(narrow, 2.0 * right - wide);
    const double greatest = passes ? right
                                   : std::max(std::min(narrow, 2.0 * right - narrow),
                                              std::min(wide, 2.0 * right - wide));
    EXPECT_EQ(rows[i].status, "solved") << i;
    EXPECT_NEAR(rows[i].values[0], least, 1e-11) << i;
    EXPECT_NEAR(rows[i].values[1], greatest, 1e-11) << i;
    EXPECT_NEAR(rows[i].values[2], wide - narrow, 1e-11) << i;
  }
  EXPECT_EQ(followed_states(file.task()), rows.size());
}

// At 84.375 degrees and near it, between two dead points, where the rate neither is clear nor rises
// clearly, it must be looked closer: it turns back four times a turn.
TEST(SweptMotions, LoseNoDeadPointsBesideAStep) {
  for (const double from : {-0.06, -0.03, 0.0, 0.05, 0.2}) {
    std::string text = kRestingSixBar;
    text.replace(text.find("from: 0 deg, to: 720 deg"),
                 24,
                 fmt::format("from: {} deg, to: {} deg", from, 720.0 + from));
    SweptFile file(text, "{vary: {x: [40.672]}, report: [g.wz.dead_points]}");
    EXPECT_EQ(rows_of(file.task(), kLanes).at(0).values.at(0), 8.0) << from;
  }
}

// A lane must not see the others.
TEST(SweptMotions, HaveTheSameBitsWithAnyNeighbours) {
  SweptFile file(kCrankRocker,
                 "{vary: {r: {from: 0.6, to: 3, step: 0.3}, k: {from: 3, to: 7, step: 0.8}}, "
                 "report: [d.wz.position.range, transmission_angle.least, dead_points, "
                 "transmission_angle.greatest, c.wz.position.range]}");
  const std::vector<Row> all = rows_of(file.task(), kLanes);
  for (std::ptrdiff_t begin = 1; begin < 4; ++begin) {
    const std::vector<Row> later = rows_of(file.task(), kLanes, static_cast<std::uint64_t>(begin));
    expect_same_bits({all.begin() + begin, all.end()}, later);
  }
}

TEST(SweptMotions, FollowInLanesNothingButLinkages) {
  const auto is_followed = [](const std::string& text, const char* sweep) {
    SweptFile file(text, sweep);
    return followed_states(file.task()) > 0;
  };
  const std::string text = kSliderCrank;
  EXPECT_TRUE(is_followed(text, "{vary: {r: [1]}, report: [s.vx.position.range]}"));
  EXPECT_FALSE(is_followed(text, "{vary: {r: [1]}, report: [s.vx.velocity.peak]}"));
  EXPECT_FALSE(is_followed(text, "{vary: {r: [1]}, report: [rod.at.x.mean]}"));
  const std::string ranged = std::string(text).replace(text.find("360 deg"), 7, "12*phi");
  EXPECT_TRUE(is_followed(ranged, "{vary: {r: [1]}, report: [s.vx.position.range]}"));
  EXPECT_FALSE(is_followed(ranged, "{vary: {phi: [20 deg]}, report: [s.vx.position.range]}"));
}

}  // namespace
}  // namespace kinestat
