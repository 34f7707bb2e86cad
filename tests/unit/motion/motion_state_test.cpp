#include "studies/motion/motion_state.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "kinematics/velocity.hpp"
#include "mechanism/couplings/reciprocity.hpp"
#include "network/bases.hpp"
#include "studies/motion/moved_mechanism.hpp"
#include "unit/motion/moving.hpp"

namespace kinestat {
namespace {

struct Subject {
  std::string file;
  std::string drive;
  double reach = 0.0;
};

void PrintTo(const Subject& subject, std::ostream* out) {
  *out << subject.file;
}

// World frame, SI.
struct PointMotion {
  Vec3 position = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
  Vec3 acceleration = Vec3::Zero();
};

PointMotion point_motion(const MotionState& state, BodyId body, const Vec3& drawn) {
  return {.position = point_position(state, body, drawn),
          .velocity = point_velocity(state, body, drawn).value,
          .acceleration = point_acceleration(state, body, drawn).value};
}

class Library : public testing::TestWithParam<Subject> {
 protected:
  Library()
      : subject_(moving_file(GetParam().file, {GetParam().drive})),
        solution_(move(subject_, 0.0, GetParam().reach, 2000)) {}

  double size() const { return subject_.network.length; }

  Moving subject_;
  MotionSolution solution_;
};

// Central differences of positions, and of velocities. Without passive freedoms, whose least motion
// is no velocity of a path.
TEST_P(Library, MovesAsItsPositionsDo) {
  ASSERT_EQ(solution_.status, MotionStatus::completed);
  EXPECT_LE(worst_closure_error(solution_), 1e-12);
  const double h = GetParam().reach / 2000.0;
  for (int k = 1; k < 2000; k += 111) {
    const MotionState before = state_at(subject_, solution_.configuration_at(k - 1), 1.0);
    const MotionState here = state_at(subject_, solution_.configuration_at(k), 1.0);
    const MotionState after = state_at(subject_, solution_.configuration_at(k + 1), 1.0);
    for (int b = 1; b < subject_.mechanism.topology.body_count(); ++b) {
      for (const Vec3& offset : {Vec3(Vec3::Zero()), Vec3(size() * Vec3::Ones())}) {
        const PointMotion p0 = point_motion(before, {b}, offset);
        const PointMotion p1 = point_motion(here, {b}, offset);
        const PointMotion p2 = point_motion(after, {b}, offset);
        const double fastest = size() + p1.velocity.norm() + p1.acceleration.norm();
        EXPECT_LE(((p2.position - p0.position) / (2.0 * h) - p1.velocity).norm(), 1e-4 * fastest);
        EXPECT_LE(((p2.velocity - p0.velocity) / (2.0 * h) - p1.acceleration).norm(),
                  1e-4 * fastest);
      }
    }
  }
}

// The moved mechanism has the velocities of the motion, by Davies' method, in all six coordinates.
TEST_P(Library, GivesTheMovedMechanismToOtherPasses) {
  ASSERT_EQ(solution_.status, MotionStatus::completed);
  Mechanism moved = subject_.mechanism;
  Primary drive;
  drive.index = subject_.network.driven_freedoms[0];
  drive.value = 1.0;
  for (int k = 0; k <= 2000; k += 111) {
    const Configuration configuration = solution_.configuration_at(k);
    const MotionState state = state_at(subject_, configuration, 1.0);
    move_mechanism(
        subject_.network, subject_.drawn, configuration, state.poses, subject_.mechanism, moved);
    const KinematicSolution velocity = solve_velocity(
        moved, motion_basis(moved.geometry, OrderChoice::minimal), std::vector<Primary>{drive});
    ASSERT_EQ(velocity.status, SolveStatus::solved) << k;
    double fastest = 0.0;
    for (const Twist& twist : velocity.bodies) {
      fastest = std::max(fastest, twist.angular.norm() + twist.linear.norm() / size());
    }
    for (std::size_t b = 0; b < state.twists.size(); ++b) {
      const Twist difference = state.twists[b] - velocity.bodies[b];
      EXPECT_LE(difference.angular.norm() + difference.linear.norm() / size(), 1e-9 * fastest);
    }
    for (std::size_t f = 0; f < velocity.rates.size(); ++f) {
      if (state.rates[f]) {
        const double unit = subject_.mechanism.topology.freedoms[f].is_rotation ? 1.0 : size();
        EXPECT_NEAR(*state.rates[f] / unit, velocity.rates[f] / unit, 1e-9 * fastest)
            << subject_.mechanism.topology.freedom_name(static_cast<int>(f));
      }
    }
  }
}

// Whatever a moved coupling bears does no work on what it frees.
TEST_P(Library, KeepsItsCouplingsReciprocal) {
  ASSERT_EQ(solution_.status, MotionStatus::completed);
  Mechanism moved = subject_.mechanism;
  const Configuration configuration = solution_.configuration_at(1234);
  const auto poses = body_poses(subject_.network, configuration);
  move_mechanism(subject_.network, subject_.drawn, configuration, poses, subject_.mechanism, moved);
  for (const CouplingTopology& coupling : moved.topology.couplings) {
    for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
      if (moved.topology.actions[static_cast<std::size_t>(a)].actuator >= 0) {
        continue;
      }
      for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count;
           ++f) {
        const double work = power(moved.geometry.actions[static_cast<std::size_t>(a)],
                                  moved.geometry.motions[static_cast<std::size_t>(f)]);
        EXPECT_NEAR(work / size(), 0.0, 1e-10)
            << moved.topology.action_name(a) << " on " << moved.topology.freedom_name(f);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files,
                         Library,
                         testing::Values(Subject{"planar/four_bar.yaml", "a.wz", 6.0},
                                         Subject{"planar/quick_return.yaml", "a.wz", 6.0},
                                         Subject{"planar/oldham_coupling.yaml", "a.wz", 6.0},
                                         Subject{"planar/toggle_press.yaml", "guide.vy", 0.001},
                                         Subject{"planar/rack_and_pinion.yaml", "a.wz", 6.0},
                                         Subject{"planar/watt_six_bar.yaml", "a.wz", 6.0},
                                         Subject{"planar/stephenson_six_bar.yaml", "a.wz", 6.0},
                                         Subject{"spatial/bennett.yaml", "a.w", 6.0},
                                         Subject{"spatial/schatz_linkage.yaml", "a.wz", 6.0},
                                         Subject{"spatial/cardan_shaft.yaml", "A.wz", 6.0},
                                         Subject{"spatial/sarrus.yaml", "a1.wx", 0.5},
                                         Subject{
                                             "spatial/self_aligning_four_bar.yaml", "a.wz", 6.0},
                                         Subject{"spatial/differential_screw.yaml", "h1.w", 6.0},
                                         Subject{"spatial/spherical_four_bar.yaml", "a.wz", 4.0},
                                         Subject{"cables/block_and_tackle.yaml", "H.vy", 0.2},
                                         Subject{"cables/weston_hoist.yaml", "H.vy", 0.2},
                                         Subject{"cables/open_belt.yaml", "A.wz", 6.0},
                                         Subject{"gears/worm_drive.yaml", "A.wx", 6.0},
                                         Subject{"transmissions/wolfrom.yaml", "I.wz", 6.0}));

}  // namespace
}  // namespace kinestat
