// Circuits, branches and poses against a tracer that knows only what each dyad keeps constant.
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/types.hpp"
#include "known_linkage.hpp"
#include "studies/synthesis/linkages/linkage_motion.hpp"
#include "studies/synthesis/linkages/verdict.hpp"

namespace kinestat {
namespace {

// x, y of the origin of the plane, and its angle.
Vec3 state_of(const Pose& pose) {
  return {pose.origin.real(), pose.origin.imag(), pose.angle};
}

Pose pose_of(const Vec3& state) {
  return {.origin = Point(state[0], state[1]), .angle = state[2]};
}

double distance(const Vec3& a, const Vec3& b) {
  return Vec3(a[0] - b[0], a[1] - b[1], std::remainder(a[2] - b[2], 2.0 * M_PI)).norm();
}

// What the dyad keeps at zero.
double breach(const Dyad& dyad, const Vec3& state) {
  const Pose pose = pose_of(state);
  const Point arm = pose.place(dyad.circle_point) - dyad.centre_point;
  switch (dyad.kind) {
    case DyadKind::crank:
      return (std::norm(arm) - dyad.length * dyad.length) / dyad.length;
    case DyadKind::slider:
      return cross(dyad.direction, arm);
    case DyadKind::inverted_slider:
      return cross(unit_vector(pose.angle) * dyad.direction, arm);
  }
  return 0.0;
}

// Numerical gradients, central differences.
Vec3 gradient(const Dyad& dyad, const Vec3& state) {
  constexpr double kStep = 1e-5;
  Vec3 result;
  for (int i = 0; i < 3; ++i) {
    const Vec3 step = kStep * Vec3::Unit(i);
    result[i] = (breach(dyad, state + step) - breach(dyad, state - step)) / (2.0 * kStep);
  }
  return result;
}

// How fast the input moves along a motion of the plane.
double input_rate(const Dyad& input, const Vec3& state, const Vec3& tangent) {
  constexpr double kStep = 1e-5;
  const Point before = pose_of(Vec3(state - kStep * tangent)).place(input.circle_point);
  const Point after = pose_of(Vec3(state + kStep * tangent)).place(input.circle_point);
  switch (input.kind) {
    case DyadKind::crank:
      return std::arg((after - input.centre_point) / (before - input.centre_point));
    case DyadKind::slider:
      return dot(after - before, input.direction);
    case DyadKind::inverted_slider:
      return tangent[2];
  }
  return 0.0;
}

constexpr double kStep = 0.01;
constexpr double kFar = 60.0;

class Tracer {
 public:
  explicit Tracer(const KnownLinkage& linkage) : linkage_(linkage) {}

  // The states from here in one sense until back again or far away; closed or not.
  std::pair<std::vector<Vec3>, bool> trace(const Vec3& start, double sense) const {
    std::vector<Vec3> way{start};
    Vec3 tangent = sense * tangent_at(start);
    for (int i = 0; i < 20000; ++i) {
      const Vec3 next = corrected(way.back() + kStep * tangent);
      Vec3 now = tangent_at(next);
      now = now.dot(tangent) < 0.0 ? Vec3(-now) : now;
      tangent = now;
      way.push_back(next);
      if (i > 10 && distance(next, start) < 0.7 * kStep) {
        return {way, true};
      }
      if (next.head<2>().norm() > kFar) {
        return {way, false};
      }
    }
    return {way, false};
  }

  Vec3 tangent_at(const Vec3& state) const {
    return gradient(linkage_.one, state).cross(gradient(linkage_.other, state)).normalized();
  }

 private:
  Vec3 corrected(Vec3 state) const {
    for (int i = 0; i < 4; ++i) {
      Eigen::Matrix<double, 2, 3> jacobian;
      jacobian << gradient(linkage_.one, state).transpose(),
          gradient(linkage_.other, state).transpose();
      const Eigen::Vector2d value(breach(linkage_.one, state), breach(linkage_.other, state));
      const Eigen::Matrix2d square = jacobian * jacobian.transpose();
      state -= jacobian.transpose() * (square.inverse() * value);
    }
    return state;
  }

  const KnownLinkage& linkage_;
};

// Which of the states a way meets, and whether the input stops on the way to them.
struct Meeting {
  bool is_met = false;
  bool without_stop = false;
};

void meet(const std::vector<Vec3>& way,
          const Dyad& input,
          const Tracer& tracer,
          const std::vector<Vec3>& states,
          std::vector<Meeting>& meetings) {
  bool has_stopped = false;
  double last = 0.0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Vec3 forward = i == 0 ? Vec3(way[1] - way[0]) : Vec3(way[i] - way[i - 1]);
    Vec3 tangent = tracer.tangent_at(way[i]);
    tangent = tangent.dot(forward) < 0.0 ? Vec3(-tangent) : tangent;
    const double rate = input_rate(input, way[i], tangent);
    has_stopped = has_stopped || (last * rate < 0.0);
    last = rate;
    for (std::size_t j = 0; j < states.size(); ++j) {
      if (distance(way[i], states[j]) < 0.6 * kStep) {
        meetings[j].is_met = true;
        meetings[j].without_stop = meetings[j].without_stop || !has_stopped;
      }
    }
  }
}

// Whether the input, going on from the first state without a stop, meets the others in their order,
// and every position that has a sense in that sense.
bool passes_in_order(const std::vector<Vec3>& way,
                     const Dyad& input,
                     const Tracer& tracer,
                     const std::vector<PositionJets>& positions) {
  std::size_t next = 0;
  double last = 0.0;
  std::vector<bool> seen(positions.size(), false);
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Vec3 forward = i == 0 ? Vec3(way[1] - way[0]) : Vec3(way[i] - way[i - 1]);
    Vec3 tangent = tracer.tangent_at(way[i]);
    tangent = tangent.dot(forward) < 0.0 ? Vec3(-tangent) : tangent;
    const double rate = input_rate(input, way[i], tangent);
    if (last * rate < 0.0) {
      return false;
    }
    last = rate;
    for (std::size_t j = 0; j < positions.size(); ++j) {
      if (seen[j] || distance(way[i], state_of(pose_of(positions[j]))) > 0.6 * kStep) {
        continue;
      }
      seen[j] = true;
      const PositionJets& met = positions[j];
      const bool has_sense = met.is_directed && met.order() > 1;
      if (j != next || (has_sense && tangent.dot(Vec3(met.x[1], met.y[1], met.angle[1])) < 0.0)) {
        return false;
      }
      if (++next == positions.size()) {
        return true;
      }
    }
  }
  return false;
}

struct Kinds {
  std::string name;
  DyadKind one;
  DyadKind other;
};

class Tracing : public testing::TestWithParam<Kinds> {};

TEST_P(Tracing, AgreesWithCircuitsAndBranches) {
  Random random(2024);
  int done = 0;
  for (int seed = 0; done < 25; ++seed) {
    SCOPED_TRACE(seed);
    ASSERT_LT(seed, 2000);
    const KnownLinkage known = random_linkage(random, GetParam().one, GetParam().other);
    const auto positions = random_positions(random, known, {1, 1, 1, 1, 1, 1});
    if (positions.empty()) {
      continue;
    }
    ++done;
    std::vector<Vec3> states;
    for (const PositionJets& position : positions) {
      states.push_back(state_of(pose_of(position)));
    }
    const Tracer tracer(known);
    const auto [forth, is_closed] = tracer.trace(states[0], 1.0);
    const auto [back, is_closed_too] = tracer.trace(states[0], -1.0);
    const Linkage linkage{.one = known.one, .other = known.other};
    for (const Drive drive : {Drive::one, Drive::other}) {
      std::vector<Meeting> meetings(states.size());
      meet(forth, input_of(linkage, drive), tracer, states, meetings);
      meet(back, input_of(linkage, drive), tracer, states, meetings);

      const DriveVerdict verdict = find_verdict(linkage, drive, positions);

      for (std::size_t j = 1; j < states.size(); ++j) {
        EXPECT_EQ(verdict.circuits[j] == verdict.circuits[0], meetings[j].is_met)
            << "position " << j << " drive " << static_cast<int>(drive);
        if (meetings[j].is_met) {
          EXPECT_EQ(verdict.branches[j] == verdict.branches[0], meetings[j].without_stop)
              << "position " << j << " drive " << static_cast<int>(drive);
        }
      }
    }
  }
}

// Half of the positions have derivatives with a sense, which is right or wrong by chance.
TEST_P(Tracing, AgreesWithTheOrder) {
  Random random(31);
  int in_order = 0;
  int done = 0;
  for (int seed = 0; done < 40; ++seed) {
    SCOPED_TRACE(seed);
    ASSERT_LT(seed, 4000);
    const KnownLinkage known = random_linkage(random, GetParam().one, GetParam().other);
    auto positions = done % 2 == 0 ? random_positions(random, known, {2, 1})
                                   : random_positions(random, known, {1, 2, 1});
    if (positions.empty()) {
      continue;
    }
    ++done;
    for (PositionJets& position : positions) {
      position.is_directed = true;
    }
    const Tracer tracer(known);
    const Vec3 start = state_of(pose_of(positions[0]));
    const std::vector<Vec3> forth = tracer.trace(start, 1.0).first;
    const std::vector<Vec3> back = tracer.trace(start, -1.0).first;
    const Linkage linkage{.one = known.one, .other = known.other};
    for (const Drive drive : {Drive::one, Drive::other}) {
      const Dyad& input = input_of(linkage, drive);
      const bool expected = passes_in_order(forth, input, tracer, positions) ||
                            passes_in_order(back, input, tracer, positions);

      const DriveVerdict verdict = find_verdict(linkage, drive, positions);

      EXPECT_EQ(verdict.passage != Passage::none, expected) << "drive " << static_cast<int>(drive);
      in_order += expected ? 1 : 0;
    }
  }
  EXPECT_GT(in_order, 5);
  EXPECT_LT(in_order, 75);
}

TEST_P(Tracing, MeetsThePosesOfTheDriveCurve) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const KnownLinkage known = random_linkage(random, GetParam().one, GetParam().other);
    const auto positions = random_positions(random, known, {1, 1});
    if (positions.empty()) {
      continue;
    }
    const Linkage linkage{.one = known.one, .other = known.other};
    for (const Drive drive : {Drive::one, Drive::other}) {
      const DriveCurve curve(linkage, drive);
      for (const PositionJets& position : positions) {
        const Pose given = pose_of(position);

        const auto found =
            curve.pose_at(curve.coordinate_of(given), curve.transmission_of(given).side);

        ASSERT_TRUE(found);
        EXPECT_LT(distance(state_of(*found), state_of(given)), 1e-6);
      }
    }
  }
}

TEST_P(Tracing, KeepsTheDyadsAlongACircuit) {
  Random random(11);
  for (int i = 0; i < 50; ++i) {
    SCOPED_TRACE(i);
    const KnownLinkage known = random_linkage(random, GetParam().one, GetParam().other);
    const auto positions = random_positions(random, known, {1, 1});
    if (positions.empty()) {
      continue;
    }
    const Linkage linkage{.one = known.one, .other = known.other};
    const LinkageMotion motion =
        trace_circuit(linkage, Drive::one, pose_of(positions[0]), 60, 20.0);

    EXPECT_GT(motion.poses.size(), 30U);
    for (const Pose& pose : motion.poses) {
      EXPECT_NEAR(breach(known.one, state_of(pose)), 0.0, 1e-6);
      EXPECT_NEAR(breach(known.other, state_of(pose)), 0.0, 1e-6);
    }
  }
}

using enum DyadKind;
INSTANTIATE_TEST_SUITE_P(
    Linkages,
    Tracing,
    testing::Values(Kinds{"FourBar", crank, crank},
                    Kinds{"SliderCrank", crank, slider},
                    Kinds{"InvertedSliderCrank", crank, inverted_slider},
                    Kinds{"SliderAndInvertedSlider", slider, inverted_slider},
                    Kinds{"DoubleSlider", slider, slider},
                    Kinds{"DoubleInvertedSlider", inverted_slider, inverted_slider}),
    [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace kinestat
