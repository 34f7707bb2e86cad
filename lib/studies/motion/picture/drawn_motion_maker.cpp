#include "studies/motion/picture/drawn_motion_maker.hpp"

#include <utility>

#include "studies/motion/configuration.hpp"
#include "studies/motion/moved_mechanism.hpp"

namespace kinestat {

namespace {

std::vector<TracedPath> empty_paths(const FoundMotion& motion) {
  std::vector<TracedPath> paths;
  for (std::size_t p = 0; p < motion.plan.trace.size(); ++p) {
    const TracedPoint& point = motion.plan.trace[p];
    paths.push_back({.name = point.name, .points = {}, .body = point.body, .drawn = point.at});
  }
  return paths;
}

}  // namespace

LinkagePosition drawn_position(const MotionNetwork& network,
                               const std::vector<DrawnCoupling>& drawn,
                               const Configuration& configuration,
                               const Mechanism& mechanism,
                               Mechanism& moved) {
  std::vector<BodyPose> poses = body_poses(network, configuration);
  move_mechanism(network, drawn, configuration, poses, mechanism, moved);
  const bool is_planar = mechanism.space == Space::planar;
  return {.poses = std::move(poses),
          .turns = is_planar ? body_turns(network, configuration) : std::vector<double>(),
          .geometry = moved.geometry};
}

DrawnMotion make_drawn_motion(const FoundMotion& motion,
                              const MotionSolution& solution,
                              const std::vector<std::size_t>& shown,
                              const Mechanism& mechanism) {
  DrawnMotion result{.positions = {}, .shares = {}, .paths = empty_paths(motion)};
  Mechanism moved = mechanism;
  for (std::size_t i = 0; i < solution.shares.size(); ++i) {
    const Configuration configuration = solution.configuration_at(static_cast<int>(i));
    const std::vector<BodyPose> poses = body_poses(motion.network, configuration);
    for (TracedPath& path : result.paths) {
      const auto body = static_cast<std::size_t>(path.body->value);
      path.points.push_back(poses[body].point(path.drawn));
    }
    if (shown[result.positions.size()] == i) {
      result.shares.push_back(solution.shares[i]);
      result.positions.push_back(
          drawn_position(motion.network, motion.drawn, configuration, mechanism, moved));
    }
  }
  return result;
}

}  // namespace kinestat
