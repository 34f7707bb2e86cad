#include <algorithm>
#include <array>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "couplings/kinds.hpp"
#include "format/mechanism_reader.hpp"
#include "mechanism/bind/bind.hpp"
#include "support/random_network.hpp"

namespace kinestat {

namespace {

// The text of one value of a key.
class ValueText {
 public:
  explicit ValueText(Space space) : space_(space) {}

  std::string operator()(bool flag) const { return flag ? "true" : "false"; }

  std::string operator()(const NetworkPoint& point) const { return vector(point.at); }

  // Directions out of the plane have three components in planar mechanisms, too.
  std::string operator()(const NetworkDirection& direction) const {
    return !direction.keyword.empty() ? direction.keyword : vector(direction.vector);
  }

  std::string operator()(const NetworkLength& length) const {
    return fmt::format("{:.17g}", length.metres);
  }

  std::string operator()(const NetworkAngle& angle) const {
    return fmt::format("{:.17g} rad", angle.radians);
  }

  std::string operator()(const NetworkScrew& screw) const {
    constexpr std::array kWords = {"rotation", "translation", "force", "couple"};
    std::string text = fmt::format(
        "{{{}: {}", kWords[static_cast<std::size_t>(screw.kind)], (*this)(screw.direction));
    if (screw.has_line()) {
      text += ", at: " + vector(screw.at);
    }
    if (screw.pitch != 0.0) {
      text += fmt::format(", pitch: {:.17g}", screw.pitch);
    }
    return text + "}";
  }

  template <class Item>
  std::string operator()(const std::vector<Item>& items) const {
    std::vector<std::string> words;
    for (const Item& item : items) {
      words.push_back((*this)(item));
    }
    return fmt::format("[{}]", fmt::join(words, ", "));
  }

 private:
  std::string vector(const Vec3& v) const {
    return space_ == Space::planar && v.z() == 0.0
               ? fmt::format("[{:.17g}, {:.17g}]", v.x(), v.y())
               : fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x(), v.y(), v.z());
  }

  Space space_;
};

std::string line_of(const NetworkCoupling& coupling, Space space) {
  std::string line = fmt::format("  {}: {{type: {}, bodies: [b{}, b{}]",
                                 coupling.name,
                                 word_of(coupling.type),
                                 coupling.tail,
                                 coupling.head);
  for (const NetworkKey& key : coupling.keys) {
    line += fmt::format(", {}: {}", key.word, std::visit(ValueText(space), key.value));
  }
  if (coupling.passive) {
    std::vector<std::string> kept;
    for (const int c : *coupling.passive) {
      kept.push_back(coupling.constraints[static_cast<std::size_t>(c)]);
    }
    line += fmt::format(", passive: [{}]", fmt::join(kept, ", "));
  }
  // A line of action at random has no other flank that were the same in a reversed coupling.
  return line + (has_teeth(coupling.type) ? ", flank: fixed}\n" : "}\n");
}

std::string line_of(const NetworkActuator& actuator, const NetworkCoupling& coupling) {
  const std::string freedom =
      coupling.is_named
          ? ", freedom: " + coupling.freedoms[static_cast<std::size_t>(actuator.freedom)]
          : "";
  return fmt::format("  {}: {{coupling: {}{}}}\n", actuator.name, coupling.name, freedom);
}

Mechanism bind_text(const std::string& text) {
  const SourceFile source{.path = "random network", .text = text};
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

}  // namespace

std::string to_yaml(const RandomNetwork& network) {
  std::string text = "kinestat: 1\nname: Random network\n";
  text += fmt::format("space: {}\n", network.space() == Space::planar ? "planar" : "spatial");
  if (!network.tree.empty()) {
    text += fmt::format("tree: [{}]\n", fmt::join(network.tree, ", "));
  }
  std::vector<std::string> bodies;
  for (const int b : network.body_order) {
    bodies.push_back(fmt::format("b{}", b));
  }
  text += fmt::format("ground: b0\nbodies: [{}]\ncouplings:\n", fmt::join(bodies, ", "));
  for (const NetworkCoupling& coupling : network.couplings) {
    text += line_of(coupling, network.space());
  }
  if (!network.actuators.empty()) {
    text += "actuators:\n";
  }
  for (const NetworkActuator& actuator : network.actuators) {
    text += line_of(actuator, network.couplings[static_cast<std::size_t>(actuator.coupling)]);
  }
  return text;
}

// By binding them between two bodies.
void update_names(RandomNetwork& network) {
  RandomNetwork two;
  two.layout = network.layout;
  two.body_order = {1};
  for (NetworkCoupling coupling : network.couplings) {
    if (coupling.is_named) {
      coupling.tail = 0;
      coupling.head = 1;
      coupling.passive.reset();
      two.couplings.push_back(coupling);
    }
  }
  if (two.couplings.empty()) {
    return;
  }
  const Topology topology = bind_text(to_yaml(two)).topology;
  for (NetworkCoupling& coupling : network.couplings) {
    const auto bound =
        std::ranges::find(topology.couplings, coupling.name, &CouplingTopology::name);
    if (!coupling.is_named || bound == topology.couplings.end()) {
      continue;
    }
    coupling.freedoms.clear();
    coupling.constraints.clear();
    for (int f = 0; f < bound->freedom_count; ++f) {
      coupling.freedoms.push_back(
          topology.freedoms[static_cast<std::size_t>(bound->first_freedom + f)].name);
    }
    for (int a = 0; a < bound->action_count; ++a) {
      const ActionLabel& action =
          topology.actions[static_cast<std::size_t>(bound->first_action + a)];
      if (action.actuator < 0) {
        coupling.constraints.push_back(action.name);
      }
    }
  }
}

Mechanism bind_network(const RandomNetwork& network) {
  return bind_text(to_yaml(network));
}

}  // namespace kinestat
