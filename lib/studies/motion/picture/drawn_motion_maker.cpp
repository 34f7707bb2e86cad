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

DrawnMotion make_drawn_motion(const FoundMotion& motion,
                              const MotionSolution& solution,
                              const std::vector<std::size_t>& shown,
                              const Mechanism& mechanism) {
  DrawnMotion result{.positions = {}, .shares = {}, .paths = empty_paths(motion)};
  const bool is_planar = mechanism.space == Space::planar;
  Mechanism moved = mechanism;
  for (std::size_t i = 0; i < solution.shares.size(); ++i) {
    const Configuration configuration = solution.configuration_at(static_cast<int>(i));
    std::vector<BodyPose> poses = body_poses(motion.network, configuration);
    for (TracedPath& path : result.paths) {
      const auto body = static_cast<std::size_t>(path.body->value);
      path.points.push_back(poses[body].point(path.drawn));
    }
    if (shown[result.positions.size()] == i) {
      move_mechanism(motion.network, motion.drawn, configuration, poses, mechanism, moved);
      result.shares.push_back(solution.shares[i]);
      result.positions.push_back(
          {.poses = std::move(poses),
           .turns = is_planar ? body_turns(motion.network, configuration) : std::vector<double>(),
           .geometry = moved.geometry});
    }
  }
  return result;
}

}  // namespace kinestat
