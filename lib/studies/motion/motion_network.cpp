#include "studies/motion/motion_network.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <set>
#include <utility>

#include "core/contract.hpp"
#include "core/index.hpp"
#include "core/motion_tolerance.hpp"
#include "network/bases.hpp"
#include "studies/mobility/passive_freedom.hpp"
#include "studies/motion/internal/rolling.hpp"

namespace kinestat {

namespace {

// A set of bodies that grow together.
class Components {
 public:
  explicit Components(int count) : parent_(at(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int root(int i) {
    while (parent_[at(i)] != i) {
      i = parent_[at(i)] = parent_[at(parent_[at(i)])];
    }
    return i;
  }

  bool join(int a, int b) {
    const int ra = root(a);
    const int rb = root(b);
    parent_[at(ra)] = rb;
    return ra != rb;
  }

 private:
  std::vector<int> parent_;
};

class NetworkMaker {
 public:
  NetworkMaker(const Mechanism& mechanism,
               std::span<const DrawnCoupling> drawn,
               std::span<const int> driven)
      : mechanism_(mechanism), topology_(mechanism.topology) {
    network_.space = mechanism.space;
    network_.length = mechanism.geometry.length;
    network_.driven_freedoms.assign(driven.begin(), driven.end());
    for (std::size_t e = 0; e < drawn.size(); ++e) {
      laws_.push_back(finite_law(topology_.couplings[e].type, mechanism.space, drawn[e]));
    }
  }

  MotionNetwork make() {
    find_tree();
    build_frames();
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      add_drawn_miss(e);
      add_closure(e);
    }
    find_arcs();
    find_drives();
    find_passive();
    find_part_lengths();
    return std::move(network_);
  }

 private:
  const CouplingTopology& coupling(int e) const { return topology_.couplings[at(e)]; }

  const FiniteLaw& law(int e) const { return laws_[at(e)]; }

  bool is_driven(int e) const {
    return std::ranges::any_of(network_.driven_freedoms, [&](int f) {
      return topology_.freedoms[at(f)].coupling.value == e;
    });
  }

  // Driven couplings first, then screws, whose turns must be counted, then those of few freedoms.
  int rank_in_tree(int e) const {
    const bool has_pitch = std::ranges::any_of(
        law(e).chain, [](const ElementaryMotion& one) { return one.pitch != 0.0; });
    return is_driven(e) ? -2 : has_pitch ? -1 : coupling(e).freedom_count;
  }

  void find_toothed() {
    toothed_.assign(at(topology_.body_count()), false);
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      if (law(e).kind == LawKind::rolling) {
        toothed_[at(coupling(e).tail.value)] = toothed_[at(coupling(e).head.value)] = true;
      }
    }
    if (std::ranges::find(toothed_, true) == toothed_.end()) {
      return;
    }
    lines_ = find_hinge_lines(topology_, mechanism_.geometry);
    meshes_ = find_meshes(topology_, mechanism_.geometry);
    for (const Mesh& mesh : meshes_) {
      const CouplingTopology& teeth = topology_.coupling(mesh.coupling);
      if (mesh.carrier) {
        carried_.insert(std::minmax(mesh.carrier->value, teeth.tail.value));
        carried_.insert(std::minmax(mesh.carrier->value, teeth.head.value));
      }
    }
  }

  // What rolls is told by turns and slides of the tree: those of toothed bodies in their carrier
  // first, then all others of toothed bodies.
  int rank_by_teeth(int e) const {
    const int tail = coupling(e).tail.value;
    const int head = coupling(e).head.value;
    return carried_.contains(std::minmax(tail, head)) ? 0
           : toothed_[at(tail)] || toothed_[at(head)] ? 1
                                                      : 2;
  }

  void find_tree() {
    find_toothed();
    std::vector<int> edges;
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      if (law(e).kind == LawKind::chain) {
        edges.push_back(e);
      }
    }
    std::ranges::stable_sort(
        edges, {}, [&](int e) { return std::pair(rank_in_tree(e), rank_by_teeth(e)); });
    Components joined(topology_.body_count());
    in_tree_.assign(at(topology_.coupling_count()), false);
    for (const int e : edges) {
      in_tree_[at(e)] = joined.join(coupling(e).tail.value, coupling(e).head.value);
    }
    for (int body = 1; body < topology_.body_count(); ++body) {
      if (joined.join(body, 0)) {
        floating_.insert(body);
      }
    }
  }

  void build_frames() {
    network_.frame_of_body.assign(at(topology_.body_count()), -1);
    network_.frame_of_body[0] = 0;
    std::vector<std::vector<int>> edges_of(at(topology_.body_count()));
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      if (in_tree_[at(e)]) {
        edges_of[at(coupling(e).tail.value)].push_back(e);
        edges_of[at(coupling(e).head.value)].push_back(e);
      }
    }
    std::deque<int> waiting = {0};
    for (const int body : floating_) {
      float_freely(body);
      waiting.push_back(body);
    }
    while (!waiting.empty()) {
      const int body = waiting.front();
      waiting.pop_front();
      for (const int e : edges_of[at(body)]) {
        const bool is_tail = coupling(e).tail.value == body;
        const int other = is_tail ? coupling(e).head.value : coupling(e).tail.value;
        if (network_.frame_of_body[at(other)] < 0) {
          network_.frame_of_body[at(other)] =
              add_chain(e, network_.frame_of_body[at(body)], is_tail ? 1.0 : -1.0);
          waiting.push_back(other);
        }
      }
    }
  }

  int add_joint(MotionJoint joint, int coordinates, int rates) {
    if (coordinates > 0) {
      joint.coordinate = network_.coordinate_count;
      joint.rate = network_.rate_count;
      network_.coordinate_count += coordinates;
      network_.rate_count += rates;
    }
    network_.joints.push_back(joint);
    return network_.frame_count++;
  }

  int add_motion(const ElementaryMotion& motion, int parent, double sense, int first_freedom) {
    const bool is_ball = motion.kind == ElementaryKind::ball;
    const int freedom = first_freedom < 0 ? -1 : first_freedom + motion.freedom;
    return add_joint({.parent = parent, .motion = motion, .sense = sense, .freedom = freedom},
                     is_ball ? 4 : 1,
                     is_ball ? 3 : 1);
  }

  int add_shift(const Vec3& shift, int parent) {
    return shift.isZero() ? parent
                          : add_joint({.parent = parent, .motion = {}, .shift = shift}, 0, 0);
  }

  // From the tail the head is shifted last, so that its point comes to that of the tail.
  int add_chain(int e, int parent, double sense) {
    std::vector<ElementaryMotion> chain = law(e).chain;
    const Vec3 shift = closure_error_of(e);
    int frame = parent;
    if (sense < 0.0) {
      std::ranges::reverse(chain);
      frame = add_shift(-shift, frame);
    }
    for (const ElementaryMotion& motion : chain) {
      frame = add_motion(motion, frame, sense, coupling(e).first_freedom);
    }
    return sense > 0.0 ? add_shift(shift, frame) : frame;
  }

  Vec3 closure_error_of(int e) const {
    for (const ClosureCondition& one : law(e).conditions) {
      if (!one.is_reversed && one.kind != ClosureKind::across) {
        return one.tail_point - one.head_point;
      }
      if (one.is_reversed) {
        return one.head_point - one.tail_point;
      }
    }
    return Vec3::Zero();
  }

  // Where the bodies are as drawn, only points can miss each other.
  void add_drawn_miss(int e) {
    double squares = 0.0;
    for (const ClosureCondition& one : law(e).conditions) {
      const Vec3 between = one.head_point - one.tail_point;
      if (one.kind == ClosureKind::meet) {
        squares += between.squaredNorm();
      } else if (one.kind == ClosureKind::along || one.kind == ClosureKind::screw) {
        const double height = one.kind == ClosureKind::along ? one.value : 0.0;
        squares += std::pow(one.tail.dot(between) - height, 2);
      }
    }
    const double distance = std::sqrt(squares);
    if (distance > kSilentCorrection * network_.length) {
      network_.drawn_misses.push_back({.coupling = CouplingId{e}, .distance = distance});
    }
  }

  // Slides along all directions, then a turn or a ball.
  void float_freely(int body) {
    const bool is_planar = network_.space == Space::planar;
    int frame = 0;
    for (int i = 0; i < (is_planar ? 2 : 3); ++i) {
      frame =
          add_motion({.kind = ElementaryKind::slide, .direction = Vec3::Unit(i)}, frame, 1.0, -1);
    }
    frame = add_motion({.kind = is_planar ? ElementaryKind::turn : ElementaryKind::ball,
                        .point = mechanism_.geometry.references[at(body)]},
                       frame,
                       1.0,
                       -1);
    network_.frame_of_body[at(body)] = frame;
  }

  void refuse(int e, MotionObstacle why) {
    network_.obstacles.push_back({.coupling = CouplingId{e}, .why = why});
  }

  void add_balls(int e) {
    for (const ElementaryMotion& motion : law(e).chain) {
      if (motion.kind == ElementaryKind::ball) {
        network_.balls.push_back({.first_freedom = coupling(e).first_freedom + motion.freedom,
                                  .tail_frame = tail_frame(e),
                                  .head_frame = head_frame(e)});
      }
    }
  }

  void add_closure(int e) {
    add_balls(e);
    switch (law(e).kind) {
      case LawKind::chain:
        if (!in_tree_[at(e)]) {
          add_conditions(e);
          add_measures(e);
        }
        return;
      case LawKind::contact:
        return add_conditions(e);
      case LawKind::rolling:
        return add_rolling(e);
      case LawKind::unknown:
        return refuse(e, reason_without_law(coupling(e).type));
    }
  }

  static MotionObstacle reason_without_law(CouplingType type) {
    return type == CouplingType::screws  ? MotionObstacle::several_screws
           : type == CouplingType::cable ? MotionObstacle::spatial_cable
                                         : MotionObstacle::unknown_profile;
  }

  int tail_frame(int e) const { return network_.frame_of_body[at(coupling(e).tail.value)]; }

  int head_frame(int e) const { return network_.frame_of_body[at(coupling(e).head.value)]; }

  void add_conditions(int e) {
    for (const ClosureCondition& condition : law(e).conditions) {
      ClosureRow row{.coupling = CouplingId{e},
                     .condition = condition,
                     .tail_frame = tail_frame(e),
                     .head_frame = head_frame(e)};
      if (condition.is_reversed) {
        std::swap(row.tail_frame, row.head_frame);
      }
      const int angles = condition.kind == ClosureKind::cable   ? 2
                         : condition.kind == ClosureKind::screw ? 1
                                                                : 0;
      if (angles > 0) {
        row.angle = network_.angle_count;
        network_.angle_count += angles;
      }
      network_.closures.push_back(row);
    }
  }

  void add_measures(int e) {
    for (const FreedomMeasure& measure : law(e).measures) {
      MeasuredFreedom one{.freedom = coupling(e).first_freedom + measure.freedom,
                          .measure = measure,
                          .tail_frame = tail_frame(e),
                          .head_frame = head_frame(e)};
      if (measure.is_turn) {
        one.angle = network_.angle_count++;
      }
      network_.measures.push_back(one);
    }
  }

  void add_rolling(int e) {
    if (auto row = find_rolling(mechanism_, network_, lines_, meshes_, CouplingId{e})) {
      network_.rollings.push_back(*std::move(row));
    } else {
      refuse(e, MotionObstacle::no_carrier);
    }
  }

  // Of cables whose sense is known; segments that leave a pulley at given points cannot be moved.
  void find_arcs() {
    const auto angle_of = [&](CouplingId segment) {
      const auto row = std::ranges::find(network_.closures, segment, &ClosureRow::coupling);
      const bool is_cable =
          row != network_.closures.end() && row->condition.kind == ClosureKind::cable;
      return is_cable ? row->angle : -1;
    };
    for (std::size_t i = 0; i < mechanism_.contacts.size(); ++i) {
      const CableContact& contact = mechanism_.contacts[i];
      const int arrives = angle_of(contact.arrives);
      const int leaves = angle_of(contact.leaves);
      if (contact.wrap && arrives >= 0 && leaves >= 0) {
        network_.arcs.push_back({.contact = static_cast<int>(i),
                                 .arrives = arrives + 1,
                                 .leaves = leaves,
                                 .sense = contact.radius < 0.0 ? -1.0 : 1.0,
                                 .drawn = *contact.wrap});
      }
    }
  }

  void find_drives() {
    for (const int f : network_.driven_freedoms) {
      const auto joint = std::ranges::find_if(network_.joints, [&](const MotionJoint& one) {
        return one.freedom == f && one.coordinate >= 0 && one.motion.kind != ElementaryKind::ball;
      });
      if (joint != network_.joints.end()) {
        network_.driven_rates.push_back(joint->rate);
        continue;
      }
      const int e = topology_.freedoms[at(f)].coupling.value;
      const bool has_position =
          std::ranges::any_of(network_.measures, [&](const auto& one) { return one.freedom == f; });
      refuse(e,
             has_position ? MotionObstacle::drives_in_circuit : MotionObstacle::undriven_position);
    }
  }

  void find_passive() {
    const auto passive =
        find_passive_freedoms(mechanism_, spatial_basis(ScrewKind::twist, network_.length));
    for (const PassiveFreedom& one : passive) {
      VecX rates = VecX::Zero(network_.rate_count);
      for (const MotionJoint& joint : network_.joints) {
        const bool is_ball = joint.motion.kind == ElementaryKind::ball;
        for (int i = 0; joint.coordinate >= 0 && joint.freedom >= 0 && i < (is_ball ? 3 : 1); ++i) {
          const double unit = joint.motion.kind == ElementaryKind::slide ? network_.length : 1.0;
          rates[joint.rate + i] = one.rates[joint.freedom + i] / unit;
        }
      }
      Eigen::Index most = 0;
      one.rates.cwiseAbs().maxCoeff(&most);
      network_.passive_motions.push_back(rates);
      network_.passive_freedoms.push_back(static_cast<int>(most));
    }
  }

  // A coupling joins parts by lengths alone: teeth compare turns, wherever their gears are. A part
  // without extent is as large as the mechanism, of which nothing else tells its lengths.
  void find_part_lengths() {
    network_.part_lengths.assign(topology_.freedoms.size(), network_.length);
    Components parts(topology_.body_count());
    int count = topology_.body_count() - 1;
    const auto part_of = [&](int e) {
      return parts.root(std::max(coupling(e).tail.value, coupling(e).head.value));
    };
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const auto [tail, head] = std::pair(coupling(e).tail.value, coupling(e).head.value);
      const bool has_lengths = std::ranges::any_of(
          law(e).conditions,
          [](const ClosureCondition& one) { return one.kind != ClosureKind::across; });
      count -= has_lengths && tail != 0 && head != 0 && parts.join(tail, head) ? 1 : 0;
    }
    if (count < 2) {
      return;
    }
    std::vector<Eigen::AlignedBox3d> boxes(at(topology_.body_count()));
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      for (const ClosureCondition& one : law(e).conditions) {
        if (one.kind != ClosureKind::across) {
          boxes[at(part_of(e))].extend(one.tail_point).extend(one.head_point);
        }
      }
    }
    for (std::size_t f = 0; f < topology_.freedoms.size(); ++f) {
      const Eigen::AlignedBox3d& box = boxes[at(part_of(topology_.freedoms[f].coupling.value))];
      const double extent = box.isEmpty() ? 0.0 : box.diagonal().norm();
      if (extent > 0.0) {
        network_.part_lengths[f] = std::min(extent, network_.length);
      }
    }
  }

  const Mechanism& mechanism_;
  const Topology& topology_;
  MotionNetwork network_;
  std::vector<FiniteLaw> laws_;
  std::vector<bool> in_tree_;
  std::set<int> floating_;
  std::vector<HingeLine> lines_;
  std::vector<Mesh> meshes_;
  std::vector<bool> toothed_;              // of each body
  std::set<std::pair<int, int>> carried_;  // a toothed body and its carrier, the lesser first
};

}  // namespace

std::string_view reason_of(MotionObstacle why) {
  switch (why) {
    case MotionObstacle::unknown_profile:
      return "the profiles that touch there are not known";
    case MotionObstacle::no_carrier:
      return "no body holds the axes of its teeth apart";
    case MotionObstacle::several_screws:
      return "the order of its freedoms is not known";
    case MotionObstacle::spatial_cable:
      return "it leaves a pulley in space, or at points that are given";
    case MotionObstacle::undriven_position:
      return "its driven freedom has no position, as a turn of a ball or a slide of a contact";
    case MotionObstacle::drives_in_circuit:
      return "the driven couplings form a circuit of their own";
  }
  return "";
}

MotionNetwork make_motion_network(const Mechanism& mechanism,
                                  std::span<const DrawnCoupling> drawn,
                                  std::span<const int> driven_freedoms) {
  KINESTAT_EXPECTS(static_cast<int>(drawn.size()) == mechanism.topology.coupling_count());
  return NetworkMaker(mechanism, drawn, driven_freedoms).make();
}

}  // namespace kinestat
