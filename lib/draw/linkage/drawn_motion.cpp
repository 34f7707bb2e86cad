#include "draw/linkage/drawn_motion.hpp"

#include <algorithm>

#include "core/contract.hpp"
#include "core/index.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// Bodies and couplings that are drawn anew for positions, all together: each is about 500 bytes.
constexpr std::size_t kMostParts = 1000;

bool has_cables(const Mechanism& mechanism) {
  return std::ranges::any_of(mechanism.topology.couplings, [](const CouplingTopology& one) {
    return one.type == CouplingType::cable;
  });
}

bool has_long_springs(const Mechanism& mechanism) {
  return std::ranges::any_of(mechanism.springs, [&](const Spring& spring) {
    return !spring.is_of_freedom() || !mechanism.topology.freedoms[at(spring.freedom)].is_rotation;
  });
}

double way_of(const Vec3& drawn, BodyId body, const std::vector<LinkagePosition>& positions) {
  double way = 0.0;
  for (std::size_t i = 1; i < positions.size(); ++i) {
    way += (positions[i].poses[at(body.value)].point(drawn) -
            positions[i - 1].poses[at(body.value)].point(drawn))
               .norm();
  }
  return way;
}

// The point of a body that moves least: in between of two positions it goes straight, and a hinge
// of the ground rests.
Vec3 stillest_point(const Mechanism& mechanism,
                    BodyId body,
                    const std::vector<LinkagePosition>& positions) {
  const Topology& topology = mechanism.topology;
  Vec3 best = mechanism.geometry.references[at(body.value)];
  double least = way_of(best, body, positions);
  for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
    const CouplingTopology& coupling = topology.couplings[e];
    if (coupling.tail != body && coupling.head != body) {
      continue;
    }
    const Vec3& point = mechanism.geometry.points[e];
    const double way = way_of(point, body, positions);
    if (way < least) {
      least = way;
      best = point;
    }
  }
  return best;
}

BodyTrack track_of(const Mechanism& mechanism,
                   BodyId body,
                   const std::vector<LinkagePosition>& positions,
                   const std::vector<std::size_t>& order) {
  BodyTrack track{.point = stillest_point(mechanism, body, positions), .places = {}, .turns = {}};
  for (const std::size_t i : order) {
    track.places.push_back(positions[i].poses[at(body.value)].point(track.point));
    track.turns.push_back(positions[i].turns[at(body.value)]);
  }
  return track;
}

}  // namespace

std::vector<std::size_t> spread_positions(std::size_t count, std::size_t most) {
  const std::size_t stride = (count + most - 1) / most;
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < count; i += stride) {
    shown.push_back(i);
  }
  if (!shown.empty() && shown.back() + 1 < count) {
    shown.push_back(count - 1);
  }
  return shown;
}

bool moves_by_matrices(const Mechanism& mechanism) {
  return mechanism.space == Space::planar && !has_cables(mechanism) && !has_long_springs(mechanism);
}

std::size_t most_frames(const Mechanism& mechanism) {
  const Topology& topology = mechanism.topology;
  const std::size_t parts = topology.bodies.size() + topology.couplings.size();
  return std::max<std::size_t>(kMostParts / parts, 2);
}

void add_places(const Mechanism& mechanism,
                const std::vector<BodyPose>& poses,
                LinkageOptions& options) {
  const Topology& topology = mechanism.topology;
  options.travel.resize(topology.couplings.size());
  for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
    const CouplingTopology& coupling = topology.couplings[e];
    const BodyId moving = coupling.head.value == 0 ? coupling.tail : coupling.head;
    options.travel[e].push_back(poses[at(moving.value)].point(mechanism.geometry.points[e]));
    options.reach.push_back(options.travel[e].back());
  }
  for (std::size_t b = 1; b < topology.bodies.size(); ++b) {
    options.reach.push_back(poses[b].point(mechanism.geometry.references[b]));
  }
}

LinkageOptions motion_options(const Mechanism& mechanism, const DrawnMotion& motion) {
  LinkageOptions options;
  options.shows_forces = false;
  options.paths = motion.paths;
  for (const LinkagePosition& position : motion.positions) {
    add_places(mechanism, position.poses, options);
  }
  if (!moves_by_matrices(mechanism) && motion.positions.size() > 1) {
    options.frames = motion.positions;
  }
  return options;
}

bool are_same(const Mechanism& mechanism,
              const std::vector<BodyPose>& some,
              const std::vector<BodyPose>& others) {
  for (std::size_t b = 0; b < some.size(); ++b) {
    const double turned = (some[b].rotation - others[b].rotation).norm();
    const double shifted = (some[b].shift - others[b].shift).norm();
    if (turned > kReportsAgree || shifted > kReportsAgree * mechanism.geometry.length) {
      return false;
    }
  }
  return true;
}

bool is_closed(const Mechanism& mechanism, const DrawnMotion& motion) {
  return are_same(mechanism, motion.positions.front().poses, motion.positions.back().poses);
}

LinkageCycle motion_cycle(const Mechanism& mechanism, const DrawnMotion& motion, double seconds) {
  KINESTAT_EXPECTS(motion.positions.size() > 1);
  const std::size_t last = motion.positions.size() - 1;
  const bool goes_round = is_closed(mechanism, motion);
  const double range = (goes_round ? 1.0 : 2.0) * (motion.shares[last] - motion.shares[0]);
  LinkageCycle cycle{.pace = {.seconds = seconds, .times = {}}, .tracks = {}, .frames = {}};
  for (std::size_t i = 0; i <= last; ++i) {
    cycle.pace.times.push_back((motion.shares[i] - motion.shares[0]) / range);
    cycle.frames.push_back(i);
  }
  for (std::size_t i = last; !goes_round && i > 0; --i) {
    cycle.pace.times.push_back(1.0 - cycle.pace.times[i - 1]);
    cycle.frames.push_back(i - 1);
  }
  for (int b = 0; mechanism.space == Space::planar && b < mechanism.topology.body_count(); ++b) {
    cycle.tracks.push_back(track_of(mechanism, BodyId{b}, motion.positions, cycle.frames));
  }
  return cycle;
}

}  // namespace kinestat
