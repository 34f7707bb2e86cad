#include "studies/motion/configuration.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/index.hpp"
#include "studies/motion/internal/closure_system.hpp"
#include "studies/motion/internal/freedom_places.hpp"

namespace kinestat {

namespace {

// Calls `task` with the equations of the network's own space.
template <class Task>
auto with_system(const MotionNetwork& network, const Task& task) {
  if (network.space == Space::planar) {
    ClosureSystem<PlanarFrames> system(network);
    return task(system);
  }
  ClosureSystem<SpatialFrames> system(network);
  return task(system);
}

}  // namespace

Configuration drawn_configuration(const MotionNetwork& network) {
  return with_system(network, [](const auto& system) {
    return Configuration{.coordinates = system.drawn_coordinates(),
                         .angles = system.drawn_angles()};
  });
}

std::vector<BodyPose> body_poses(const MotionNetwork& network, const Configuration& configuration) {
  return with_system(network, [&]<class Frames>(ClosureSystem<Frames>& system) {
    system.evaluate(configuration.coordinates, configuration.angles);
    std::vector<BodyPose> poses;
    for (const int frame : network.frame_of_body) {
      BodyPose pose = Frames::pose(system.frames()[at(frame)]);
      pose.shift = network.length * pose.shift;
      poses.push_back(pose);
    }
    return poses;
  });
}

std::vector<double> body_turns(const MotionNetwork& network, const Configuration& configuration) {
  std::vector<double> of_frame(at(network.frame_count), 0.0);
  for (std::size_t j = 0; j < network.joints.size(); ++j) {
    const MotionJoint& joint = network.joints[j];
    const bool turns = joint.coordinate >= 0 && joint.motion.kind == ElementaryKind::turn;
    const double sense = joint.sense * joint.motion.direction.z();
    of_frame[j + 1] = of_frame[at(joint.parent)] +
                      (turns ? sense * configuration.coordinates[at(joint.coordinate)] : 0.0);
  }
  std::vector<double> turns;
  for (const int frame : network.frame_of_body) {
    turns.push_back(of_frame[at(frame)]);
  }
  return turns;
}

std::vector<std::optional<double>> freedom_positions(const MotionNetwork& network,
                                                     const Mechanism& mechanism,
                                                     const Configuration& configuration) {
  return with_system(network, [&](auto& system) {
    system.evaluate(configuration.coordinates, configuration.angles);
    return freedom_positions_of(system, network, mechanism, configuration);
  });
}

std::vector<double> contact_arcs(const MotionNetwork& network, const Configuration& configuration) {
  if (network.arcs.empty()) {
    return {};
  }
  return with_system(network, [&](const auto& system) {
    std::vector<double> result;
    for (const ContactArc& one : network.arcs) {
      result.push_back(one.at(configuration.angles, system.drawn_angles()));
    }
    return result;
  });
}

std::vector<CouplingMiss> find_misses(const MotionNetwork& network,
                                      const Configuration& configuration,
                                      double least) {
  return with_system(network, [&]<class Frames>(ClosureSystem<Frames>& system) {
    system.evaluate(configuration.coordinates, configuration.angles);
    std::map<int, CouplingMiss> misses;
    for (int r = 0; r < system.row_count(); ++r) {
      const double missed = system.residuals()[at(r)];
      CouplingMiss& miss = misses[system.row_couplings()[at(r)]];
      double& part = system.is_length()[at(r)] ? miss.distance : miss.angle;
      part = std::hypot(part, missed);
    }
    std::vector<CouplingMiss> result;
    for (auto& [coupling, miss] : misses) {
      if (std::max(miss.distance, miss.angle) > least) {
        miss.coupling = CouplingId{coupling};
        miss.distance *= network.length;
        result.push_back(miss);
      }
    }
    return result;
  });
}

double closure_error(const MotionNetwork& network, const Configuration& configuration) {
  return with_system(network, [&](auto& system) {
    system.evaluate(configuration.coordinates, configuration.angles);
    return system.largest_residual();
  });
}

}  // namespace kinestat
