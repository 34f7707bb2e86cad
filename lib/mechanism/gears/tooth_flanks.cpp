// Before what takes moments of lines for any type of number.
#include "mechanism/gears/tooth_flanks.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/index.hpp"
#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/dual_vector.hpp"
#include "mechanism/gears/hinge_lines.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

// What is rounding beside the rest of a vector is zero.
template <class Scalar>
Vec3Of<Scalar> without_rounding(Vec3Of<Scalar> vector) {
  const double size = values_of<Scalar>(vector).norm();
  for (Scalar& part : vector) {
    if (std::abs(value_of(part)) <= kCancellation * size) {
      part = part - Scalar(value_of(part));
    }
  }
  return vector;
}

template <>
Vec3Of<ExactInput> without_rounding<ExactInput>(Vec3Of<ExactInput> vector) {
  const double size = values_of<ExactInput>(vector).norm();
  for (ExactInput& part : vector) {
    if (std::abs(part.value) <= kCancellation * size) {
      part.value = 0.0;
    }
  }
  return vector;
}

// What a body moves about or along.
struct Axle {
  int freedom = -1;
  Twist motion;
};

// The curvature of the pitch surface along `normal`, towards its axis; 0 of what slides.
double curvature(const Twist& motion, const Vec3& at, const Vec3& normal) {
  if (motion.angular.isZero(0.0)) {
    return 0.0;
  }
  const Vec3 to_axis = motion.angular.cross(velocity_at<double>(motion, at));
  const double arm = to_axis.norm();
  const double cosine = arm > 0.0 ? normal.dot(to_axis) / arm : 0.0;
  return std::abs(cosine) > kSlackInCarrier ? cosine / arm : 0.0;
}

class ToothSearch {
 public:
  ToothSearch(const Topology& topology, const Geometry& geometry)
      : topology_(topology), geometry_(geometry) {
    join_rigid_bodies();
    axles_.resize(topology.bodies.size());
    for (const HingeLine& line : find_hinge_lines(topology, geometry)) {
      add_line(line);
    }
    for (const CouplingTopology& coupling : topology.couplings) {
      if (coupling.type == CouplingType::prismatic || coupling.type == CouplingType::cylindrical) {
        add_guide(coupling);
      }
    }
  }

  std::optional<ToothRule> rule_of(const TurningTeeth& teeth) const {
    const CouplingTopology& coupling = topology_.coupling(teeth.coupling);
    const Twist& relative = geometry_.motions[at(coupling.first_freedom)];
    const Vec3& point = geometry_.points[at(teeth.coupling.value)];
    const Vec3 slide = velocity_at<double>(relative, point);
    const double turn = relative.angular.norm();
    const bool slides = slide.norm() > kSlackInCarrier * geometry_.length * turn;
    Search search{.relative = relative,
                  .point = point,
                  .second = slides ? slide.normalized() : Vec3(relative.angular / turn),
                  .rule = {.coupling = teeth.coupling,
                           .action = teeth.action,
                           .slides = slides,
                           .internal = teeth.internal,
                           .has_other = teeth.has_other}};
    return find(axles_of(coupling.tail), axles_of(coupling.head), search)
               ? std::optional(search.rule)
               : std::nullopt;
  }

 private:
  struct Search {
    Twist relative;
    Vec3 point;
    Vec3 second;  // a direction of the pitch plane beside the pitch velocity
    ToothRule rule;
    std::optional<Vec3> normal = {};
    bool is_ambiguous = false;
  };

  // What is fixed to a shaft turns with it.
  void join_rigid_bodies() {
    leader_.resize(topology_.bodies.size());
    for (std::size_t b = 0; b < leader_.size(); ++b) {
      leader_[b] = static_cast<int>(b);
    }
    for (const CouplingTopology& coupling : topology_.couplings) {
      if (coupling.type == CouplingType::rigid) {
        const int tail = leader_of(coupling.tail);
        const int head = leader_of(coupling.head);
        leader_[at(std::max(tail, head))] = std::min(tail, head);
      }
    }
  }

  int leader_of(BodyId body) const {
    int leader = body.value;
    while (leader_[at(leader)] != leader) {
      leader = leader_[at(leader)];
    }
    return leader;
  }

  const std::vector<Axle>& axles_of(BodyId body) const { return axles_[at(leader_of(body))]; }

  void add_line(const HingeLine& line) {
    const CouplingTopology& hinge = topology_.coupling(line.hinges.front());
    int freedom = hinge.first_freedom;
    while (!topology_.freedoms[at(freedom)].is_rotation) {
      ++freedom;
    }
    const Axle axle{.freedom = freedom, .motion = geometry_.motions[at(freedom)]};
    std::vector<int> leaders;
    for (const BodyId body : line.bodies) {
      leaders.push_back(leader_of(body));
    }
    std::ranges::sort(leaders);
    leaders.erase(std::unique(leaders.begin(), leaders.end()), leaders.end());
    for (const int leader : leaders) {
      axles_[at(leader)].push_back(axle);
    }
  }

  void add_guide(const CouplingTopology& coupling) {
    for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count; ++f) {
      if (!topology_.freedoms[at(f)].is_rotation) {
        const Axle axle{.freedom = f, .motion = geometry_.motions[at(f)]};
        axles_[at(leader_of(coupling.tail))].push_back(axle);
        axles_[at(leader_of(coupling.head))].push_back(axle);
      }
    }
  }

  bool find(const std::vector<Axle>& tails, const std::vector<Axle>& heads, Search& search) const {
    const CouplingTopology& coupling = topology_.coupling(search.rule.coupling);
    for (const Axle& tail : tails) {
      for (const Axle& head : heads) {
        if (makes(search.relative, tail.motion, head.motion)) {
          take(&tail, &head, search);
        }
      }
    }
    // A wheel that floats between others turns about no hinge.
    if (heads.empty() && leader_of(coupling.tail) != 0) {
      for (const Axle& tail : tails) {
        take(&tail, nullptr, search);
      }
    }
    if (tails.empty() && leader_of(coupling.head) != 0) {
      for (const Axle& head : heads) {
        take(nullptr, &head, search);
      }
    }
    return search.normal && !search.is_ambiguous;
  }

  Vec6 in_sizes(const Twist& twist) const {
    Vec6 result = twist.coordinates();
    result.tail<3>() /= geometry_.length;
    return result;
  }

  // Whether the teeth move as they do where tail and head move so in one body.
  bool makes(const Twist& relative, const Twist& tail, const Twist& head) const {
    Eigen::Matrix<double, 6, 2> both;
    both << in_sizes(tail), in_sizes(head);
    const Eigen::Matrix2d normal = both.transpose() * both;
    const Vec6 wanted = in_sizes(relative);
    if (std::abs(normal.determinant()) <= kParallelAxes * kParallelAxes) {
      return false;
    }
    const Eigen::Vector2d rates = normal.inverse() * (both.transpose() * wanted);
    return (both * rates - wanted).norm() <= kSlackInCarrier * wanted.norm();
  }

  // Both must give one plane, wherever several would do.
  void take(const Axle* tail, const Axle* head, Search& search) const {
    Vec3 normal = Vec3::Zero();
    bool by_head = false;
    for (const Axle* axle : {tail, head}) {
      if (axle == nullptr) {
        continue;
      }
      const Vec3 velocity = velocity_at<double>(axle->motion, search.point);
      const double arm = axle->motion.angular.isZero(0.0) ? 1.0 : geometry_.length;
      if (velocity.norm() <= kParallelAxes * arm) {
        continue;
      }
      const Vec3 across = velocity.normalized().cross(search.second);
      if (across.norm() > normal.norm() * (1.0 + kSlackInCarrier)) {
        normal = across;
        by_head = axle == head;
      }
    }
    if (normal.norm() <= kSlackInCarrier) {
      return;
    }
    normal.normalize();
    if (search.normal) {
      search.is_ambiguous =
          search.is_ambiguous || search.normal->cross(normal).norm() > kSlackInCarrier;
      return;
    }
    search.normal = normal;
    search.rule.tail = tail != nullptr ? tail->freedom : -1;
    search.rule.head = head != nullptr ? head->freedom : -1;
    search.rule.by_head = by_head;
  }

  const Topology& topology_;
  const Geometry& geometry_;
  std::vector<int> leader_;               // of bodies that are rigid together
  std::vector<std::vector<Axle>> axles_;  // of each leader
};

template <class Scalar>
Vec3Of<Scalar> normal_at(const ToothRule& rule,
                         const Topology& topology,
                         const std::vector<TwistOf<Scalar>>& motions,
                         const Vec3Of<Scalar>& point) {
  const TwistOf<Scalar>& relative = motions[at(topology.coupling(rule.coupling).first_freedom)];
  const Vec3Of<Scalar> velocity =
      velocity_at<Scalar>(motions[at(rule.by_head ? rule.head : rule.tail)], point);
  const Vec3Of<Scalar> second =
      rule.slides ? velocity_at<Scalar>(relative, point) : relative.angular;
  return without_rounding<Scalar>(velocity.cross(second));
}

// 1: the head is pushed along `normal`, a unit vector; -1: against it; 0: not known.
int push_on_head(const ToothRule& rule,
                 const Twist& tail,
                 const Twist& head,
                 const Vec3& at,
                 const Vec3& normal) {
  const double of_tail = rule.tail >= 0 ? curvature(tail, at, normal) : 0.0;
  const double of_head = rule.head >= 0 ? curvature(head, at, normal) : 0.0;
  const bool knows_both = rule.tail >= 0 && rule.head >= 0;
  const double push = std::abs(of_head) >= std::abs(of_tail) ? of_head : -of_tail;
  const bool is_alike = std::abs(of_head - of_tail) <= kSlackInCarrier * std::abs(push);
  if ((!knows_both && rule.internal) || is_alike || push == 0.0) {
    return 0;
  }
  return push > 0.0 ? 1 : -1;
}

}  // namespace

std::vector<ToothRule> find_tooth_rules(const Topology& topology,
                                        const Geometry& geometry,
                                        const std::vector<TurningTeeth>& teeth) {
  std::vector<ToothRule> rules;
  if (teeth.empty()) {
    return rules;
  }
  const ToothSearch search(topology, geometry);
  for (const TurningTeeth& one : teeth) {
    if (const std::optional<ToothRule> rule = search.rule_of(one)) {
      rules.push_back(*rule);
    }
  }
  return rules;
}

template <class Scalar>
Vec3Of<Scalar> pitch_normal(const ToothRule& rule,
                            const Topology& topology,
                            const GeometryOf<Scalar>& geometry) {
  return normal_at<Scalar>(
      rule, topology, geometry.motions, geometry.points[at(rule.coupling.value)]);
}

bool is_pulling(const ToothRule& rule,
                const Topology& topology,
                const std::vector<Twist>& motions,
                const Vec3& point,
                const Vec3& line) {
  const auto motion_of = [&](int freedom) { return freedom >= 0 ? motions[at(freedom)] : Twist(); };
  const Vec3 normal = normal_at<double>(rule, topology, motions, point).normalized();
  const int push = push_on_head(rule, motion_of(rule.tail), motion_of(rule.head), point, normal);
  return push * normal.dot(line) < -kParallelAxes;
}

template Vec3 pitch_normal(const ToothRule&, const Topology&, const Geometry&);
template Vec3Of<Dual> pitch_normal(const ToothRule&, const Topology&, const GeometryOf<Dual>&);
template Vec3Of<ExactInput> pitch_normal(const ToothRule&,
                                         const Topology&,
                                         const GeometryOf<ExactInput>&);

}  // namespace kinestat
