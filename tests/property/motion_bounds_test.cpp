// Velocities and accelerations of random mechanisms against a solution with a hundred digits: no
// difference is larger than its bound, and bounds are not far above what they bound.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "property/precise_motion.hpp"
#include "unit/motion/moving.hpp"

namespace kinestat {
namespace {

struct Sample {
  std::string text;
  std::vector<std::string> drives;
  std::vector<double> ways;
  std::vector<double> speeds;
};

class Draw {
 public:
  explicit Draw(int seed) : engine_(static_cast<unsigned>(seed)) {}

  double between(double from, double to) {
    return from + (to - from) * std::uniform_real_distribution<double>()(engine_);
  }

  // Of numbers that differ by orders of magnitude.
  double order_between(double from, double to) {
    return std::exp(between(std::log(from), std::log(to)));
  }

  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }

  Vec3 point(double size = 1.0) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }

 private:
  std::mt19937 engine_;
};

std::string written(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", v[0], v[1], v[2]);
}

// A screw in a tube that swings, its nut hinged to an arm; all may stand on a carriage that turns.
Sample electric_cylinder(Draw& draw) {
  const Vec3 origin = draw.order_between(1.0, 1e4) * draw.point() * draw.below(2);
  const bool is_carried = draw.below(2) == 0;
  const bool is_far = draw.below(3) == 0;
  const double lead = 2.0 * std::numbers::pi * draw.order_between(1e-4, 1.0);
  const double hinge = draw.between(0.4, 1.5);
  const double rise = draw.between(-0.5, 0.5);
  const Vec3 arm_end(draw.between(-0.8, 0.3), draw.between(0.3, 1.0), 0.0);
  const Vec3 tube(hinge, rise, 0.0);
  const Vec3 axis = arm_end - tube;
  const Vec3 nut = tube + draw.between(0.2, 0.8) * axis;
  const Vec3 guide = nut + Vec3(0.0, 0.0, draw.between(-0.3, 0.3));
  const std::string base = is_carried ? "c" : "g";
  Sample sample;
  sample.text = fmt::format("ground: g\nbodies: [{}{}arm, tube, screw, nut]\ncouplings:\n",
                            is_carried ? "c, " : "",
                            is_far ? "far, " : "");
  const auto add = [&](const char* name,
                       const char* type,
                       const std::string& tail,
                       const char* head,
                       const Vec3& at,
                       const Vec3& along,
                       const std::string& more = "") {
    sample.text += fmt::format("  {}: {{type: {}, bodies: [{}, {}], at: {}, axis: {}{}}}\n",
                               name,
                               type,
                               tail,
                               head,
                               written(origin + at),
                               written(along),
                               more);
  };
  const Vec3 z = Vec3::UnitZ();
  add("a", "revolute", base, "arm", Vec3::Zero(), z);
  add("t", "revolute", base, "tube", tube, z);
  add("s", "revolute", "tube", "screw", nut, axis);
  add("h", "helical", "screw", "nut", nut, axis, fmt::format(", lead: {}", lead));
  add("p", "prismatic", "tube", "nut", guide, axis);
  add("e", "revolute", "nut", "arm", arm_end, z);
  const double way = draw.between(-0.1, 0.1);
  const bool is_by_screw = draw.below(3) == 0;
  sample.drives = {is_by_screw ? "s.w" : "a.w"};
  sample.ways = {is_by_screw ? way / lead : way};
  sample.speeds = {is_by_screw ? 1.0 / lead : 1.0};
  if (is_carried) {
    add("k", "revolute", "g", "c", draw.point(), draw.below(2) == 0 ? z : draw.point());
    sample.drives.emplace_back("k.w");
    sample.ways.push_back(draw.between(-1.0, 1.0));
    sample.speeds.push_back(draw.order_between(0.1, 100.0));
  }
  if (is_far) {
    add("m", "revolute", "g", "far", draw.order_between(1.0, 1e4) * draw.point(), z);
    sample.drives.emplace_back("m.w");
    sample.ways.push_back(1.0);
    sample.speeds.push_back(draw.order_between(0.01, 100.0));
  }
  return sample;
}

// Seven joints of all kinds in one circuit.
Sample spatial_circuit(Draw& draw) {
  const Vec3 origin = draw.order_between(1.0, 1e4) * draw.point() * draw.below(2);
  Sample sample;
  sample.text = "ground: b0\nbodies: [b1, b2, b3, b4, b5, b6]\ncouplings:\n";
  int slides = 0;
  for (int j = 0; j < 7; ++j) {
    const int kind = j == 0 ? 0 : draw.below(4);
    const bool is_slide = kind == 2 && slides < 2;
    slides += is_slide ? 1 : 0;
    const std::string lead =
        kind == 3 ? fmt::format(", lead: {}", draw.order_between(1e-3, 5.0)) : "";
    sample.text += fmt::format("  j{}: {{type: {}, bodies: [b{}, b{}], at: {}, axis: {}{}}}\n",
                               j,
                               is_slide    ? "prismatic"
                               : kind == 3 ? "helical"
                                           : "revolute",
                               j,
                               (j + 1) % 7,
                               written(origin + draw.point()),
                               written(draw.point()),
                               lead);
  }
  sample.drives = {"j0.w"};
  sample.ways = {draw.between(-0.05, 0.05)};
  sample.speeds = {draw.order_between(0.1, 10.0)};
  return sample;
}

// Four bars, or a crank and a slider, on a carriage that turns.
Sample planar_linkage(Draw& draw) {
  const Vec3 origin = draw.order_between(1.0, 1e4) * draw.point() * draw.below(2);
  const auto at = [&](double x, double y) {
    return fmt::format("[{}, {}]", origin[0] + x, origin[1] + y);
  };
  const bool is_slider = draw.below(2) == 0;
  const double x = draw.between(-0.3, 0.3);
  const double y = draw.order_between(1e-4, 0.3);
  Sample sample;
  sample.text = fmt::format(
      "space: planar\nground: g\nbodies: [c, crank, rod, out]\ncouplings:\n"
      "  k: {{type: revolute, bodies: [g, c], at: {}}}\n"
      "  a: {{type: revolute, bodies: [c, crank], at: {}}}\n"
      "  b: {{type: revolute, bodies: [crank, rod], at: {}}}\n"
      "  d: {{type: revolute, bodies: [rod, out], at: {}}}\n"
      "  e: {{type: {}, bodies: [c, out], at: {}{}}}\n",
      at(draw.between(-1.0, 1.0), draw.between(-1.0, 1.0)),
      at(0.0, 0.0),
      at(x, y),
      at(draw.between(0.6, 1.2), draw.between(-0.5, 0.5)),
      is_slider ? "prismatic" : "revolute",
      at(draw.between(0.8, 1.5), draw.between(-0.9, -0.6)),
      is_slider ? fmt::format(", axis: [1, {}]", draw.between(-0.3, 0.3)) : "");
  sample.drives = {"a.wz", "k.wz"};
  sample.ways = {draw.between(-0.3, 0.3), draw.between(-1.0, 1.0)};
  sample.speeds = {1.0, draw.order_between(0.1, 1e3) * draw.below(2)};
  return sample;
}

struct Tally {
  std::vector<double> widths;  // bounds as multiples of errors
  double narrowest = 1e300;
  std::string where;

  void add(const std::string& what, double value, const BigFloat& right, double bound) {
    const double error = abs(BigFloat(value) - right).convert_to<double>();
    if (error > 0.0) {
      widths.push_back(bound / error);
      if (widths.back() < narrowest) {
        narrowest = widths.back();
        where = fmt::format("{}: {} is off by {}, its bound is {}", what, value, error, bound);
      }
    }
  }

  double median() {
    std::ranges::sort(widths);
    return widths.empty() ? 0.0 : widths[widths.size() / 2];
  }
};

// False where the position is not reached, or singular.
bool compare(const Sample& sample, Tally& first, Tally& second) {
  const Moving subject = moving(sample.text, sample.drives);
  if (subject.network.driven_freedoms.size() != sample.drives.size()) {
    return false;
  }
  MotionTask task;
  GivenSpeeds speeds;
  for (std::size_t d = 0; d < sample.drives.size(); ++d) {
    task.drives.push_back(
        {.freedom = subject.network.driven_freedoms[d], .from = 0.0, .to = sample.ways[d]});
    speeds.drives.push_back({.speed = sample.speeds[d], .acceleration = 0.5 * sample.speeds[d]});
  }
  task.steps = 1;
  const MotionSolution solution = solve_motion(subject.network, task);
  if (solution.status != MotionStatus::completed) {
    return false;
  }
  const Configuration configuration = solution.configuration_at(1);
  MotionStates states(subject.network, subject.mechanism);
  const MotionState plain = states.solve(configuration, speeds, StateDetail::acceleration);
  const MotionState bounded =
      states.solve_bounded(configuration, speeds, StateDetail::acceleration);
  if (plain.is_singular || plain.twist_rates.empty()) {
    return false;
  }
  std::vector<FiniteLaw> laws;
  for (int e = 0; e < subject.mechanism.topology.coupling_count(); ++e) {
    laws.push_back(finite_law(subject.mechanism.topology.coupling(CouplingId{e}).type,
                              subject.network.space,
                              subject.drawn[static_cast<std::size_t>(e)]));
  }
  std::vector<double> near;
  for (const auto& position :
       freedom_positions(subject.network, subject.mechanism, configuration)) {
    near.push_back(position.value_or(0.0));
  }
  std::vector<PreciseDrive> drives;
  for (std::size_t d = 0; d < sample.drives.size(); ++d) {
    drives.push_back(
        {.freedom = subject.network.driven_freedoms[d],
         .position = near[static_cast<std::size_t>(subject.network.driven_freedoms[d])],
         .speed = speeds.drives[d].speed,
         .acceleration = speeds.drives[d].acceleration});
  }
  const PreciseMotion right = precise_motion(subject.mechanism, laws, drives, near);
  if (right.miss > 1e-40) {
    return false;
  }
  const StateBounds& bounds = bounded.bounds;
  for (std::size_t f = 0; f < near.size(); ++f) {
    const std::string name = subject.mechanism.topology.freedom_name(static_cast<int>(f));
    first.add(name + " position", near[f], right.positions[f], bounds.positions[f]);
    first.add(name + " rate", plain.rates[f].value(), right.rates[f], bounds.rates[f]);
    second.add(name, plain.rate_rates[f].value(), right.rate_rates[f], bounds.rate_rates[f]);
  }
  for (std::size_t b = 1; b < plain.twists.size(); ++b) {
    const std::string& name = subject.mechanism.topology.bodies[b].name;
    const BodyBounds& body = bounds.bodies[b];
    for (int i = 0; i < 3; ++i) {
      const auto angular = static_cast<std::size_t>(i);
      const auto linear = angular + 3;
      first.add(
          name + " angular", plain.twists[b].angular[i], right.twists[b][angular], body.angular);
      first.add(name + " linear", plain.twists[b].linear[i], right.twists[b][linear], body.linear);
      second.add(name + " angular",
                 plain.twist_rates[b].angular[i],
                 right.twist_rates[b][angular],
                 body.angular_rate);
      second.add(name + " linear",
                 plain.twist_rates[b].linear[i],
                 right.twist_rates[b][linear],
                 body.linear_rate);
    }
  }
  return true;
}

using Maker = Sample (*)(Draw&);

class MotionBounds : public testing::TestWithParam<std::pair<const char*, Maker>> {};

TEST_P(MotionBounds, HoldAndAreNotFarAboveTheErrors) {
  constexpr int kSamples = 150;
  // Sums of some ten terms, each by what its operations may round together at most.
  constexpr double kWidth = 2e3;
  Tally first;
  Tally second;
  int compared = 0;
  for (int seed = 0; seed < kSamples; ++seed) {
    Draw draw(seed);
    const Sample sample = GetParam().second(draw);
    Tally velocities;
    Tally accelerations;
    compared += compare(sample, velocities, accelerations) ? 1 : 0;
    EXPECT_GE(velocities.narrowest, 1.0) << seed << ": " << velocities.where << "\n" << sample.text;
    EXPECT_GE(accelerations.narrowest, 1.0) << seed << ": " << accelerations.where << "\n"
                                            << sample.text;
    first.widths.insert(first.widths.end(), velocities.widths.begin(), velocities.widths.end());
    second.widths.insert(
        second.widths.end(), accelerations.widths.begin(), accelerations.widths.end());
  }
  EXPECT_GE(compared, kSamples / 2);
  EXPECT_LE(first.median(), kWidth);
  EXPECT_LE(second.median(), kWidth);
  RecordProperty("compared", compared);
  RecordProperty("median_of_velocities", std::to_string(first.median()));
  RecordProperty("median_of_accelerations", std::to_string(second.median()));
}

INSTANTIATE_TEST_SUITE_P(Random,
                         MotionBounds,
                         testing::Values(std::pair<const char*, Maker>("cylinder",
                                                                       electric_cylinder),
                                         std::pair<const char*, Maker>("circuit", spatial_circuit),
                                         std::pair<const char*, Maker>("planar", planar_linkage)),
                         [](const auto& one) { return std::string(one.param.first); });

}  // namespace
}  // namespace kinestat
