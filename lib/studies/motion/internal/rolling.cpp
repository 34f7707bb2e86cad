#include "studies/motion/internal/rolling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/index.hpp"
#include "studies/motion/internal/motion_limits.hpp"

namespace kinestat {

namespace {

// The sum of coordinates by which a body turns or slides relative to another on one line.
struct LineMotion {
  std::vector<int> rates;
  std::vector<double> signs;
  Vec6 screw = Vec6::Zero();
};

class RollingSearch {
 public:
  RollingSearch(const Mechanism& mechanism,
                const MotionNetwork& network,
                std::span<const HingeLine> lines,
                CouplingId id)
      : mechanism_(mechanism),
        network_(network),
        lines_(lines),
        id_(id),
        coupling_(mechanism.topology.coupling(id)) {}

  // Joints from the ground to a frame.
  std::vector<int> path_to(int frame) const {
    std::vector<int> path;
    for (; frame != 0; frame = network_.joints[at(frame - 1)].parent) {
      path.push_back(frame - 1);
    }
    std::ranges::reverse(path);
    return path;
  }

  // Of the drawn position, about the origin of the network.
  static Vec6 screw_of(const ElementaryMotion& motion) {
    const Twist twist = motion.kind == ElementaryKind::slide
                            ? unit_translation<double>(motion.direction)
                            : unit_rotation<double>(motion.direction, motion.point) +
                                  motion.pitch * unit_translation<double>(motion.direction);
    return twist.coordinates();
  }

  Vec6 in_sizes(Vec6 screw) const {
    screw.tail<3>() /= network_.length;
    return screw;
  }

  // By the coordinate, which is in sizes for a slide.
  Vec6 unit_screw(const ElementaryMotion& motion) const {
    const Vec6 screw = screw_of(motion);
    return motion.kind == ElementaryKind::slide ? screw : in_sizes(screw);
  }

  // The joints of the tree from one body to another, and 1 or -1 for each that leads away from the
  // ground or back to it.
  std::vector<std::pair<int, double>> joints_between(int from, int to) const {
    const std::vector<int> back = path_to(network_.frame_of_body[at(from)]);
    const std::vector<int> forth = path_to(network_.frame_of_body[at(to)]);
    const auto apart = std::ranges::mismatch(back, forth);
    std::vector<std::pair<int, double>> result;
    std::for_each(apart.in1, back.end(), [&](int j) { result.emplace_back(j, -1.0); });
    std::for_each(apart.in2, forth.end(), [&](int j) { result.emplace_back(j, 1.0); });
    return result;
  }

  // How a body moves in another, if it does so on one line.
  std::optional<LineMotion> line_motion(int carrier, int body) const {
    LineMotion result;
    for (const auto& [j, sign] : joints_between(carrier, body)) {
      if (!add_to_line(j, sign, result)) {
        return hinge_motion(carrier, body);
      }
    }
    return result.rates.empty() ? std::nullopt : std::optional(result);
  }

  // In a plane all turns on the way add up to that about the line of hinges which joins the two,
  // also where the tree leaves some of these out.
  std::optional<LineMotion> hinge_motion(int carrier, int body) const {
    const auto line = std::ranges::find_if(lines_, [&](const HingeLine& one) {
      return std::ranges::binary_search(one.bodies, BodyId{carrier}) &&
             std::ranges::binary_search(one.bodies, BodyId{body});
    });
    if (network_.space != Space::planar || line == lines_.end()) {
      return std::nullopt;
    }
    LineMotion result;
    result.screw = in_sizes(unit_rotation<double>(line->direction, line->point).coordinates());
    for (const auto& [j, sign] : joints_between(carrier, body)) {
      const MotionJoint& joint = network_.joints[at(j)];
      if (joint.coordinate >= 0 && joint.motion.kind == ElementaryKind::turn) {
        const double along = line->direction.dot(joint.motion.direction);
        result.rates.push_back(joint.rate);
        result.signs.push_back(sign * along * joint.sense);
      }
    }
    return result;
  }

  bool add_to_line(int j, double sign, LineMotion& line) const {
    const MotionJoint& joint = network_.joints[at(j)];
    if (joint.coordinate < 0) {
      return true;
    }
    if (joint.motion.kind == ElementaryKind::ball) {
      return false;
    }
    const Vec6 screw = unit_screw(joint.motion);
    if (line.rates.empty()) {
      line.screw = screw;
    }
    const double along = line.screw.dot(screw) > 0.0 ? 1.0 : -1.0;
    if ((screw - along * line.screw).norm() > kParallelAxes) {
      return false;
    }
    line.rates.push_back(joint.rate);
    line.signs.push_back(sign * along * joint.sense);
    return true;
  }

  // In the carrier the teeth allow h · $_head - t · $_tail, h and t in one ratio.
  std::optional<RollingRow> roll_in(int carrier) const {
    const auto tail = line_motion(carrier, coupling_.tail.value);
    const auto head = line_motion(carrier, coupling_.head.value);
    if (!tail || !head || coupling_.freedom_count == 0) {
      return std::nullopt;
    }
    const auto ratio = coupling_.freedom_count == 1 ? rolling_ratio(tail->screw, head->screw)
                                                    : contact_ratio(tail->screw, head->screw);
    if (!ratio || ratio->isZero()) {
      return std::nullopt;
    }
    return make_row(carrier, {*tail, (*ratio)[0]}, {*head, (*ratio)[1]});
  }

 private:
  // t and h by which the one motion of the teeth is made of the two; empty where it is not.
  std::optional<Eigen::Vector2d> rolling_ratio(const Vec6& tail, const Vec6& head) const {
    const Vec6 rolls =
        in_sizes(mechanism_.geometry.motions[at(coupling_.first_freedom)].coordinates());
    Eigen::Matrix<double, 6, 2> both;
    both << -tail, head;
    const Eigen::Matrix2d normal = both.transpose() * both;
    if (std::abs(normal.determinant()) <= kParallelAxes * kParallelAxes) {
      return std::nullopt;
    }
    const Eigen::Vector2d ratio = normal.inverse() * (both.transpose() * rolls);
    const bool holds = (both * ratio - rolls).norm() <= kSlackInCarrier * rolls.norm();
    return holds ? std::optional(ratio) : std::nullopt;
  }

  // Where the teeth only touch, neither turn does work on their force.
  std::optional<Eigen::Vector2d> contact_ratio(const Vec6& tail, const Vec6& head) const {
    if (coupling_.action_count == 0) {
      return std::nullopt;
    }
    Vec6 acts = mechanism_.geometry.actions[at(coupling_.first_action)].coordinates();
    acts.head<3>() /= network_.length;
    return Eigen::Vector2d(acts.dot(head), acts.dot(tail));
  }

  // Tail and head turn in the ratio t : h, so that t · head - h · tail = 0.
  RollingRow make_row(int carrier,
                      const std::pair<LineMotion, double>& tail,
                      const std::pair<LineMotion, double>& head) const {
    RollingRow row;
    row.coupling = id_;
    row.carrier = BodyId{carrier};
    const double size = std::max(std::abs(tail.second), std::abs(head.second));
    const bool by_head = std::abs(head.second) == size;
    for (std::size_t i = 0; i < head.first.rates.size(); ++i) {
      row.rates.push_back(head.first.rates[i]);
      row.factors.push_back(tail.second / size * head.first.signs[i]);
      row.freedom_factors.push_back(by_head ? head.first.signs[i] / head.second : 0.0);
    }
    for (std::size_t i = 0; i < tail.first.rates.size(); ++i) {
      row.rates.push_back(tail.first.rates[i]);
      row.factors.push_back(-head.second / size * tail.first.signs[i]);
      row.freedom_factors.push_back(by_head ? 0.0 : tail.first.signs[i] / tail.second);
    }
    return row;
  }

  const Mechanism& mechanism_;
  const MotionNetwork& network_;
  std::span<const HingeLine> lines_;
  CouplingId id_;
  const CouplingTopology& coupling_;
};

}  // namespace

std::optional<RollingRow> find_rolling(const Mechanism& mechanism,
                                       const MotionNetwork& network,
                                       std::span<const HingeLine> lines,
                                       std::span<const Mesh> meshes,
                                       CouplingId coupling) {
  std::vector<int> carriers;
  for (const Mesh& mesh : meshes) {
    if (mesh.coupling == coupling && mesh.carrier) {
      carriers.push_back(mesh.carrier->value);
    }
  }
  for (int body = 0; body < mechanism.topology.body_count(); ++body) {
    carriers.push_back(body);
  }
  const CouplingTopology& ends = mechanism.topology.coupling(coupling);
  const RollingSearch search(mechanism, network, lines, coupling);
  for (const int carrier : carriers) {
    if (carrier == ends.tail.value || carrier == ends.head.value) {
      continue;
    }
    if (auto row = search.roll_in(carrier)) {
      return row;
    }
  }
  return std::nullopt;
}

}  // namespace kinestat
