// Mechanisms from the text of a file, set in motion.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "studies/motion/motion.hpp"
#include "studies/motion/motion_state.hpp"
#include "support/mechanism_text.hpp"

namespace kinestat {

/// A description with what is bound of it.
struct Moving {
  Mechanism mechanism;
  std::vector<DrawnCoupling> drawn;
  MotionNetwork network;

  double position(const Configuration& configuration, std::string_view freedom) const {
    const auto all = freedom_positions(network, mechanism, configuration);
    return all.at(static_cast<std::size_t>(freedom_index(mechanism, freedom))).value();
  }

  BodyId body(std::string_view name) const {
    for (int b = 0; b < mechanism.topology.body_count(); ++b) {
      if (mechanism.topology.bodies[static_cast<std::size_t>(b)].name == name) {
        return BodyId{b};
      }
    }
    ADD_FAILURE() << "no body " << name;
    return {};
  }

  CouplingId coupling(std::string_view name) const {
    for (int e = 0; e < mechanism.topology.coupling_count(); ++e) {
      if (mechanism.topology.couplings[static_cast<std::size_t>(e)].name == name) {
        return CouplingId{e};
      }
    }
    ADD_FAILURE() << "no coupling " << name;
    return {};
  }
};

/// Driven by these freedoms ("a.wz"). A complaint of reader or binder is a failed test.
inline Moving moving(const std::string& text, const std::vector<std::string>& drives) {
  const SourceFile source{.path = "test", .text = "kinestat: 1\n" + text};
  Diagnostics found;
  Moving result;
  const std::optional<YamlNode> tree = read_yaml(source, {}, found);
  const auto description = tree ? read_mechanism(*tree, found) : std::nullopt;
  auto mechanism = description ? bind(*description, found) : std::nullopt;
  for (const Diagnostic& item : found.items()) {
    ADD_FAILURE() << item.code << " in line " << item.where.line << ": " << item.message;
  }
  if (mechanism) {
    result.mechanism = *std::move(mechanism);
    result.drawn = bind_drawn_couplings(*description, result.mechanism);
    std::vector<int> freedoms;
    for (const std::string& drive : drives) {
      freedoms.push_back(freedom_index(result.mechanism, drive));
    }
    result.network = make_motion_network(result.mechanism, result.drawn, freedoms);
  }
  return result;
}

/// A file of the library, driven by these freedoms.
inline Moving moving_file(const std::string& path, const std::vector<std::string>& drives) {
  std::ifstream file(KINESTAT_MECHANISMS "/" + path);
  std::stringstream text;
  text << file.rdbuf();
  const std::string head = "kinestat: 1\n";
  const std::string all = text.str();
  const std::size_t first = all.find(head);
  EXPECT_NE(first, std::string::npos) << path;
  return moving(first == std::string::npos ? all : all.substr(first + head.size()), drives);
}

/// One drive of the network from `from` to `to`.
inline MotionSolution move(const Moving& subject, double from, double to, int steps) {
  return solve_motion(
      subject.network,
      {.drives = {{.freedom = subject.network.driven_freedoms.at(0), .from = from, .to = to}},
       .steps = steps});
}

/// Where `point`, as drawn on the body, is at a position of the motion.
inline Vec3 point_at(const Moving& subject,
                     const MotionSolution& solution,
                     int position,
                     BodyId body,
                     const Vec3& point) {
  const auto poses = body_poses(subject.network, solution.configuration_at(position));
  return poses.at(static_cast<std::size_t>(body.value)).point(point);
}

inline MotionState state_at(const Moving& subject,
                            const Configuration& configuration,
                            double speed,
                            double acceleration = 0.0) {
  const DriveSpeed drive{.speed = speed, .acceleration = acceleration};
  return MotionStates(subject.network, subject.mechanism)
      .solve(configuration,
             {.drives = std::vector<DriveSpeed>(subject.network.driven_freedoms.size(), drive),
              .passive = {}},
             StateDetail::acceleration);
}

inline double worst_closure_error(const MotionSolution& solution) {
  return solution.closure_errors.empty() ? 1.0 : std::ranges::max(solution.closure_errors);
}

}  // namespace kinestat
