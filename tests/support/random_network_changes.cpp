#include "support/random_network_changes.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "graph/spanning_tree.hpp"
#include "support/random.hpp"

namespace kinestat {

namespace {

// Moves the values of keys.
class Mover {
 public:
  explicit Mover(const RigidMotion& motion)
      : motion_(motion), turns_(!motion.rotation.isIdentity(0.0)) {}

  void operator()(NetworkPoint& point) const { move(point.at); }

  void operator()(NetworkDirection& direction) const {
    if (turns_) {
      direction = {motion_.rotation * direction.vector};
    }
  }

  void operator()(NetworkScrew& screw) const {
    (*this)(screw.direction);
    move(screw.at);
  }

  template <class Item>
  void operator()(std::vector<Item>& items) const {
    for (Item& item : items) {
      (*this)(item);
    }
  }

  void operator()(bool&) const {}

  void operator()(NetworkLength&) const {}

  void operator()(NetworkAngle&) const {}

 private:
  void move(Vec3& point) const { point = motion_.rotation * point + motion_.translation; }

  const RigidMotion& motion_;
  bool turns_;
};

// Scales the values of keys.
class Scaler {
 public:
  explicit Scaler(double factor) : factor_(factor) {}

  void operator()(NetworkPoint& point) const { point.at *= factor_; }

  void operator()(NetworkLength& length) const { length.metres *= factor_; }

  void operator()(NetworkScrew& screw) const {
    screw.at *= factor_;
    screw.pitch *= factor_;
  }

  void operator()(std::vector<NetworkScrew>& screws) const {
    for (NetworkScrew& screw : screws) {
      (*this)(screw);
    }
  }

  void operator()(bool&) const {}

  void operator()(NetworkDirection&) const {}

  void operator()(NetworkAngle&) const {}

  void operator()(std::vector<NetworkDirection>&) const {}

 private:
  double factor_;
};

template <class Change>
void change_keys(RandomNetwork& network, const Change& change) {
  for (NetworkCoupling& coupling : network.couplings) {
    for (NetworkKey& key : coupling.keys) {
      std::visit(change, key.value);
    }
  }
}

// Returns the numbers that its freedoms have then.
std::vector<int> reverse(NetworkCoupling& coupling, Space space) {
  std::swap(coupling.tail, coupling.head);
  if (coupling.type == CouplingType::universal) {
    std::ranges::reverse(std::get<std::vector<NetworkDirection>>(*coupling.find("axes")));
    return {1, 0};
  }
  if (coupling.type == CouplingType::cable) {
    std::swap(*coupling.find("from"), *coupling.find("to"));
    return space == Space::planar ? std::vector<int>{1, 0} : std::vector<int>{2, 3, 0, 1, 4};
  }
  return {0, 1, 2, 3, 4, 5};
}

}  // namespace

RandomNetwork with_another_tree(RandomNetwork network, std::uint64_t seed) {
  Random random(seed);
  std::vector<int> order;
  Digraph graph{.vertex_count = network.body_count(), .edges = {}};
  for (std::size_t e = 0; e < network.couplings.size(); ++e) {
    order.push_back(static_cast<int>(e));
  }
  random.shuffle(order);
  for (const int e : order) {
    const NetworkCoupling& coupling = network.couplings[static_cast<std::size_t>(e)];
    graph.edges.push_back({.tail = coupling.tail, .head = coupling.head});
  }
  network.tree.clear();
  const std::optional<SpanningTree> tree = find_spanning_tree(graph);
  for (const int branch : tree->branches) {
    const int e = order[static_cast<std::size_t>(branch)];
    network.tree.push_back(network.couplings[static_cast<std::size_t>(e)].name);
  }
  return network;
}

RandomNetwork with_reversed_edges(RandomNetwork network,
                                  std::uint64_t seed,
                                  std::vector<bool>& reversed) {
  Random random(seed);
  reversed.clear();
  for (std::size_t e = 0; e < network.couplings.size(); ++e) {
    reversed.push_back(random.chance(0.5));
    if (!reversed.back()) {
      continue;
    }
    const std::vector<int> numbers = reverse(network.couplings[e], network.space());
    for (NetworkActuator& actuator : network.actuators) {
      if (actuator.coupling == static_cast<int>(e)) {
        actuator.freedom = numbers[static_cast<std::size_t>(actuator.freedom)];
      }
    }
  }
  update_names(network);
  return network;
}

RandomNetwork with_renumbered_bodies(RandomNetwork network, std::uint64_t seed) {
  Random random(seed);
  random.shuffle(network.body_order);
  return network;
}

// ω' = R ω; v_O' = R v_O + p x ω', the velocity of what is at the origin now.
Twist RigidMotion::operator*(const Twist& twist) const {
  const Vec3 angular = rotation * twist.angular;
  return {.angular = angular, .linear = rotation * twist.linear + translation.cross(angular)};
}

// F' = R F; T_O' = R T_O + p x F'.
Wrench RigidMotion::operator*(const Wrench& wrench) const {
  const Vec3 force = rotation * wrench.force;
  return {.moment = rotation * wrench.moment + translation.cross(force), .force = force};
}

RigidMotion make_random_motion(const RandomNetwork& network, std::uint64_t seed) {
  Random random(seed);
  RigidMotion motion;
  const bool is_planar = network.space() == Space::planar;
  const Vec3 axis = is_planar ? Vec3(Vec3::UnitZ()) : random.direction().normalized();
  const double angle = random.between(0.3, 2.8);
  motion.translation = random.vector();
  if (is_planar) {
    motion.translation.z() = 0.0;
  }
  if (network.names_world) {
    // By quarters, which leaves directions between whole coordinates as they are.
    motion.translation = (4.0 * motion.translation).array().round() / 4.0;
  } else {
    motion.rotation = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  }
  return motion;
}

RandomNetwork moved(RandomNetwork network, const RigidMotion& motion) {
  change_keys(network, Mover(motion));
  update_names(network);
  return network;
}

RandomNetwork scaled(RandomNetwork network, double factor) {
  change_keys(network, Scaler(factor));
  return network;
}

}  // namespace kinestat
