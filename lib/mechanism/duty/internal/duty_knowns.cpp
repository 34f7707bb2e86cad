#include "mechanism/duty/internal/duty_knowns.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

// The index of the item of that name.
template <class Item>
std::optional<std::size_t> find_named(const std::vector<Item>& items,
                                      std::string_view name,
                                      std::string Item::*of) {
  const auto at =
      std::ranges::find(items, name, [&](const Item& item) { return std::string_view(item.*of); });
  return at == items.end() ? std::nullopt
                           : std::optional(static_cast<std::size_t>(at - items.begin()));
}

}  // namespace

std::string_view word_of(DutySide side) {
  return side == DutySide::motion ? "motion" : "action";
}

QuantityKind measure_of(const Topology& topology, std::size_t actuator, DutySide side) {
  const ActuatorTopology& one = topology.actuators[actuator];
  return side == DutySide::motion
             ? kind_of(topology.freedoms[static_cast<std::size_t>(one.freedom)])
             : kind_of(topology.actions[static_cast<std::size_t>(one.action)]);
}

std::optional<std::size_t> find_actuator(const Topology& topology, std::string_view name) {
  return find_named(topology.actuators, name, &ActuatorTopology::name);
}

std::optional<std::size_t> find_case(const Mechanism& mechanism, std::string_view label) {
  return find_named(mechanism.cases, label, &Case::label);
}

std::string cases_hint(const Mechanism& mechanism, std::string_view label) {
  std::vector<std::string> labels;
  for (const Case& one : mechanism.cases) {
    labels.push_back(one.label);
  }
  return labels.empty() ? "add a section 'cases' or 'shift'"
                        : guess_before(label, labels, "cases and gears are " + plain_list(labels));
}

std::string why_no_point(const Case& which) {
  if (std::ranges::any_of(which.actions, &Primary::moves)) {
    return fmt::format("an action of case '{}' follows a curve", which.label);
  }
  return which.asks_motions && which.asks_actions
             ? ""
             : fmt::format("case '{}' gives no {}",
                           which.label,
                           which.asks_motions ? "torque or force" : "motion");
}

void set_known(std::size_t known, DutySide side, double value, DutyPoint& point) {
  (side == DutySide::motion ? point.motions : point.actions)[known] = value;
}

}  // namespace kinestat
