#include "support/random_network.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace kinestat {

namespace {

// Those of a kind, or any that are listed, are the same in every position of the world. Others are
// named by its axes and chosen at will.
std::vector<int> choose_passive(const NetworkCoupling& coupling, bool at_will, Random& random) {
  const bool is_by_kind = !at_will && coupling.find("constraints") == nullptr;
  // None, the couples or the forces; of a complement none, as its wrenches are mixed.
  const int kind = random.whole(0, coupling.type == CouplingType::screws ? 0 : 2);
  std::vector<int> kept;
  for (std::size_t c = 0; c < coupling.constraints.size(); ++c) {
    const bool is_couple = coupling.constraints[c].front() == 'T';
    const bool is_of_kind = (kind == 1 && is_couple) || (kind == 2 && !is_couple);
    if (is_by_kind ? is_of_kind : random.chance(0.5)) {
      kept.push_back(static_cast<int>(c));
    }
  }
  return kept;
}

void add_passive(const NetworkPlan& plan, RandomNetwork& network, Random& random) {
  if (plan.completeness == Completeness::complementary) {
    return;
  }
  for (NetworkCoupling& coupling : network.couplings) {
    if (coupling.is_named && has_place(coupling) && random.chance(0.5)) {
      const bool at_will = plan.names_world && random.chance(0.5);
      network.names_world = network.names_world || at_will;
      coupling.passive = choose_passive(coupling, at_will, random);
    }
  }
}

// A clutch or brake has another of its own.
void add_actuators(const NetworkPlan& plan, RandomNetwork& network, Random& random) {
  for (std::size_t e = 0; e < network.couplings.size(); ++e) {
    const NetworkCoupling& coupling = network.couplings[e];
    std::vector<int> freedoms = own_freedoms(coupling, network.space());
    const bool at_will = plan.names_world && coupling.is_named && has_place(coupling);
    if (at_will) {
      freedoms.resize(coupling.freedoms.size());
      std::ranges::generate(freedoms, [i = 0]() mutable { return i++; });
    } else if (!coupling.is_named &&
               (freedoms != std::vector<int>{0} || coupling.type == CouplingType::planar)) {
      continue;  // several freedoms, of which one would be named
    }
    for (const int freedom : freedoms) {
      if (random.chance(plan.actuated)) {
        network.names_world = network.names_world || at_will;
        network.actuators.push_back({.name = fmt::format("u{}", network.actuators.size()),
                                     .coupling = static_cast<int>(e),
                                     .freedom = freedom});
      }
    }
  }
}

// Only those stay named that need it.
void drop_names(RandomNetwork& network) {
  for (std::size_t e = 0; e < network.couplings.size(); ++e) {
    NetworkCoupling& coupling = network.couplings[e];
    coupling.is_named = coupling.is_named &&
                        (coupling.passive || std::ranges::count(network.actuators,
                                                                static_cast<int>(e),
                                                                &NetworkActuator::coupling) > 0);
  }
}

}  // namespace

RandomNetwork make_random_network(std::uint64_t seed) {
  Random random(seed);
  const NetworkPlan plan = make_network_plan(seed, random);
  RandomNetwork network;
  network.layout = plan.layout;
  for (int b = 1; b < plan.body_count; ++b) {
    network.body_order.push_back(b);
  }
  LayoutDraw draw(plan.layout, random);
  for (const PlannedCoupling& planned : plan.couplings) {
    NetworkCoupling coupling;
    coupling.name = fmt::format("c{}", network.couplings.size());
    coupling.type = planned.type;
    coupling.tail = planned.edge.tail;
    coupling.head = planned.edge.head;
    coupling.keys = draw_keys(coupling.type, plan.completeness, draw);
    coupling.is_named = random.chance(0.4);
    network.couplings.push_back(coupling);
  }
  update_names(network);
  add_passive(plan, network, random);
  add_actuators(plan, network, random);
  drop_names(network);
  return network;
}

}  // namespace kinestat
