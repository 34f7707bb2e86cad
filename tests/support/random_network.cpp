#include "support/random_network.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "graph/spanning_tree.hpp"
#include "io/mechanism_reader.hpp"
#include "mechanism/bind.hpp"
#include "support/random.hpp"

namespace kinestat {

namespace {

constexpr int kMostBodies = 30;

// What all couplings of one network share.
struct Frame {
  Vec3 normal = Vec3::UnitZ();  ///< of the plane, or the direction of all axes
  Vec3 centre = Vec3::Zero();   ///< the common point of all axes
};

Vec3 perpendicular_to(const Vec3& axis, Random& random) {
  Vec3 result = axis.cross(random.direction());
  while (result.norm() < 0.1) {
    result = axis.cross(random.direction());
  }
  return result.normalized();
}

void take_keyword(NetworkCoupling& coupling, Random& random, int axis_count) {
  const int axis = random.whole(0, axis_count - 1);
  const bool is_negative = random.chance(0.3);
  coupling.axis = (is_negative ? -1.0 : 1.0) * Vec3::Unit(axis);
  coupling.keyword = fmt::format("{}{}", is_negative ? "-" : "", "xyz"[axis]);
}

void place_planar(NetworkCoupling& coupling, Random& random) {
  coupling.at = random.vector();
  coupling.at.z() = 0.0;
  coupling.axis = Vec3::UnitZ();
  if (coupling.type == CouplingType::prismatic) {
    if (random.chance(0.4)) {
      take_keyword(coupling, random, 2);
    } else {
      coupling.axis = perpendicular_to(Vec3::UnitZ(), random);
    }
  }
  coupling.line_of_action = perpendicular_to(Vec3::UnitZ(), random);
}

void place_spatial(NetworkCoupling& coupling, Layout layout, const Frame& frame, Random& random) {
  coupling.at = random.vector();
  coupling.axis = random.direction();
  const bool slides = coupling.type == CouplingType::prismatic;
  switch (layout) {
    case Layout::general:
      if (random.chance(0.3)) {
        take_keyword(coupling, random, 3);
      }
      break;
    case Layout::lattice:
      for (double& coordinate : coupling.at) {
        coordinate = random.whole(-2, 2);
      }
      take_keyword(coupling, random, 3);
      break;
    case Layout::parallel_axes:
      coupling.axis = (random.chance(0.3) ? -1.0 : 1.0) * frame.normal;
      break;
    case Layout::planar_in_space:
      coupling.axis = slides ? perpendicular_to(frame.normal, random) : frame.normal;
      break;
    case Layout::spherical:
      coupling.at = frame.centre + random.magnitude() * coupling.axis;
      break;
    case Layout::planar:
      break;
  }
  coupling.line_of_action = perpendicular_to(coupling.axis, random);
}

CouplingType choose_type(bool is_passive, Layout layout, Random& random) {
  const double share = random.share();
  if (!is_passive && share < 0.25) {
    return CouplingType::gear;
  }
  if (!is_passive && share < 0.35) {
    return share < 0.3 ? CouplingType::clutch : CouplingType::brake;
  }
  if (share > 0.97) {
    return CouplingType::rigid;
  }
  if (share > 0.75 && layout != Layout::spherical) {
    return CouplingType::prismatic;
  }
  return CouplingType::revolute;
}

// A tree of mostly long chains, then chords.
std::vector<Edge> make_edges(int body_count, Space space, Random& random) {
  std::vector<Edge> edges;
  for (int b = 1; b < body_count; ++b) {
    const int other = random.chance(0.75) ? b - 1 : random.whole(0, b - 1);
    edges.push_back({.tail = other, .head = b});
  }
  const int most = space == Space::planar ? 1 + body_count / 3 : 1 + body_count / 5;
  const int chord_count = random.whole(1, most);
  for (int i = 0; i < chord_count; ++i) {
    const int tail = random.whole(0, body_count - 1);
    const int head = (tail + random.whole(1, body_count - 1)) % body_count;
    edges.push_back({.tail = tail, .head = head});
  }
  for (Edge& edge : edges) {
    if (random.chance(0.4)) {
      std::swap(edge.tail, edge.head);
    }
  }
  random.shuffle(edges);
  return edges;
}

Layout choose_layout(Random& random) {
  constexpr std::array<Layout, 8> kShares = {Layout::planar,
                                             Layout::planar,
                                             Layout::planar,
                                             Layout::general,
                                             Layout::lattice,
                                             Layout::parallel_axes,
                                             Layout::planar_in_space,
                                             Layout::spherical};
  return kShares[static_cast<std::size_t>(random.whole(0, 7))];
}

std::string list_of(const Vec3& vector, Space space) {
  return space == Space::planar
             ? fmt::format("[{:.17g}, {:.17g}]", vector.x(), vector.y())
             : fmt::format("[{:.17g}, {:.17g}, {:.17g}]", vector.x(), vector.y(), vector.z());
}

std::string line_of(const NetworkCoupling& coupling, Space space) {
  std::string line = fmt::format("  {}: {{type: {}, bodies: [b{}, b{}], at: {}",
                                 coupling.name,
                                 word_of(coupling.type),
                                 coupling.tail,
                                 coupling.head,
                                 list_of(coupling.at, space));
  const bool turns_in_plane = space == Space::planar && coupling.type != CouplingType::prismatic;
  if (coupling.type != CouplingType::rigid && !turns_in_plane) {
    line += fmt::format(
        ", axis: {}", coupling.keyword.empty() ? list_of(coupling.axis, space) : coupling.keyword);
  }
  if (coupling.type == CouplingType::gear) {
    line += fmt::format(", line_of_action: {}", list_of(coupling.line_of_action, space));
  }
  return line + "}\n";
}

std::string joined(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words) {
    result += (result.empty() ? "" : ", ") + word;
  }
  return "[" + result + "]";
}

}  // namespace

RandomNetwork make_random_network(std::uint64_t seed) {
  Random random(seed);
  const bool is_passive = seed % 2 == 0;
  RandomNetwork network;
  network.layout = choose_layout(random);
  network.space = network.layout == Layout::planar ? Space::planar : Space::spatial;
  // Small networks are as likely as large ones, because special cases live there.
  const int body_count = random.chance(0.5) ? random.whole(3, 8) : random.whole(9, kMostBodies);
  for (int b = 1; b < body_count; ++b) {
    network.body_order.push_back(b);
  }
  const Frame frame{.normal = random.direction(), .centre = random.vector()};
  for (const Edge& edge : make_edges(body_count, network.space, random)) {
    NetworkCoupling coupling;
    coupling.name = fmt::format("c{}", network.couplings.size());
    coupling.type = choose_type(is_passive, network.layout, random);
    coupling.tail = edge.tail;
    coupling.head = edge.head;
    if (network.space == Space::planar) {
      place_planar(coupling, random);
    } else {
      place_spatial(coupling, network.layout, frame, random);
    }
    if (coupling.type != CouplingType::rigid && random.chance(0.4)) {
      network.actuators.push_back(
          {.name = fmt::format("u{}", network.actuators.size()), .coupling = coupling.name});
    }
    network.couplings.push_back(coupling);
  }
  return network;
}

std::string to_yaml(const RandomNetwork& network) {
  std::string text = "kinestat: 1\nname: Random network\n";
  text += fmt::format("space: {}\n", network.space == Space::planar ? "planar" : "spatial");
  if (!network.tree.empty()) {
    text += fmt::format("tree: {}\n", joined(network.tree));
  }
  std::vector<std::string> bodies;
  for (const int b : network.body_order) {
    bodies.push_back(fmt::format("b{}", b));
  }
  text += fmt::format("ground: b0\nbodies: {}\ncouplings:\n", joined(bodies));
  for (const NetworkCoupling& coupling : network.couplings) {
    text += line_of(coupling, network.space);
  }
  if (!network.actuators.empty()) {
    text += "actuators:\n";
  }
  for (const NetworkActuator& actuator : network.actuators) {
    text += fmt::format("  {}: {{coupling: {}}}\n", actuator.name, actuator.coupling);
  }
  return text;
}

Mechanism bind_network(const RandomNetwork& network) {
  const SourceFile source{.path = "random network", .text = to_yaml(network)};
  Diagnostics found;
  const std::optional<YamlNode> tree = read_yaml(source, {}, found);
  std::optional<MechanismDescription> description;
  if (tree) {
    description = read_mechanism(*tree, found);
  }
  std::optional<Mechanism> mechanism;
  if (description) {
    mechanism = bind(*description, found);
  }
  for (const Diagnostic& item : found.items()) {
    ADD_FAILURE() << item.code << " in line " << item.where.line << ": " << item.message << "\n"
                  << source.text;
  }
  return mechanism.value_or(Mechanism{});
}

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
  for (NetworkCoupling& coupling : network.couplings) {
    reversed.push_back(random.chance(0.5));
    if (reversed.back()) {
      std::swap(coupling.tail, coupling.head);
    }
  }
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

RigidMotion make_random_motion(Space space, std::uint64_t seed) {
  Random random(seed);
  RigidMotion motion;
  const Vec3 axis = space == Space::planar ? Vec3(Vec3::UnitZ()) : random.direction().normalized();
  motion.rotation = Eigen::AngleAxisd(random.between(0.3, 2.8), axis).toRotationMatrix();
  motion.translation = random.vector();
  if (space == Space::planar) {
    motion.translation.z() = 0.0;
  }
  return motion;
}

RandomNetwork moved(RandomNetwork network, const RigidMotion& motion) {
  for (NetworkCoupling& coupling : network.couplings) {
    coupling.at = motion.rotation * coupling.at + motion.translation;
    coupling.axis = motion.rotation * coupling.axis;
    coupling.line_of_action = motion.rotation * coupling.line_of_action;
    coupling.keyword.clear();
  }
  return network;
}

RandomNetwork scaled(RandomNetwork network, double factor) {
  for (NetworkCoupling& coupling : network.couplings) {
    coupling.at *= factor;
  }
  return network;
}

}  // namespace kinestat
