#include "support/random_network.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "graph/digraph.hpp"
#include "support/random_network_catalogue.hpp"

namespace kinestat {

namespace {

// How large a network is and which couplings it draws from.
struct Plan {
  Space space = Space::spatial;
  int body_count = 0;
  int most_chords = 0;
  int least_mobility = 0;  ///< F - λ l; no chord is added that would leave less
  Completeness completeness = Completeness::any;
  std::vector<CouplingType> types;        ///< drawn alike
  std::vector<CouplingType> usual_types;  ///< of the other couplings; repeated ones more often
  double usual = 0.0;                     ///< share of the others
  double chained = 0.0;                   ///< share of the bodies that follow the one before
  double actuated = 0.0;                  ///< share of the freedoms
  bool names_world = false;               ///< some are named by axes of the world
};

// A coupling before it has a place.
struct Branch {
  Edge edge;
  CouplingType type = CouplingType::revolute;
};

Layout choose_layout(bool is_small_spatial, Random& random) {
  constexpr std::array<Layout, 11> kShares = {Layout::planar,
                                              Layout::planar,
                                              Layout::planar,
                                              Layout::general,
                                              Layout::lattice,
                                              Layout::parallel_axes,
                                              Layout::planar_in_space,
                                              Layout::spherical,
                                              Layout::general,
                                              Layout::general,
                                              Layout::lattice};
  return kShares[static_cast<std::size_t>(is_small_spatial ? random.whole(3, 10)
                                                           : random.whole(0, 7))];
}

// The types that make a layout what it is.
std::vector<CouplingType> usual_types_of(Layout layout, Completeness completeness) {
  using enum CouplingType;
  std::vector<CouplingType> types = {revolute, revolute, revolute, revolute};
  if (layout == Layout::spherical) {
    types.insert(types.end(), {universal, spherical});
  } else {
    types.insert(types.end(), {prismatic, prismatic});
  }
  if (layout == Layout::parallel_axes || layout == Layout::lattice) {
    types.insert(types.end(), {helical, cylindrical});
  }
  if (layout == Layout::parallel_axes || layout == Layout::planar_in_space) {
    types.push_back(CouplingType::planar);
  }
  if (completeness == Completeness::any) {
    types.insert(types.end(), {gear, gear, clutch, brake});
  }
  return types;
}

// One to six types, so that networks of few types are as likely as those of many.
std::vector<CouplingType> choose_types(Space space, Completeness completeness, Random& random) {
  std::vector<CouplingType> types = types_of(space, completeness);
  random.shuffle(types);
  types.resize(static_cast<std::size_t>(random.whole(1, 6)));
  return types;
}

Plan make_plan(bool is_small_spatial, bool is_complementary, Layout layout, Random& random) {
  Plan plan;
  plan.space = layout == Layout::planar ? Space::planar : Space::spatial;
  plan.completeness = is_complementary ? Completeness::complementary : Completeness::any;
  plan.usual_types = usual_types_of(layout, plan.completeness);
  plan.types = choose_types(plan.space, plan.completeness, random);
  plan.usual = random.chance(0.3) ? 1.0 : random.between(0.2, 0.6);
  plan.chained = random.chance(0.4) ? 1.0 : 0.7;
  plan.actuated = random.chance(0.5) ? 1.0 : random.between(0.2, 0.8);
  plan.names_world = random.chance(0.2);
  if (is_small_spatial) {
    plan.body_count = random.whole(3, random.chance(0.5) ? 6 : 12);
    plan.most_chords = plan.body_count;
    plan.least_mobility = random.whole(-2, 2);
    return plan;
  }
  // Small networks are as likely as large ones, because special cases live there.
  plan.body_count = random.chance(0.5) ? random.whole(3, 8) : random.whole(9, 30);
  const int most = plan.body_count / (plan.space == Space::planar ? 3 : 5);
  plan.most_chords = random.whole(1, 1 + most);
  plan.least_mobility = -6 * most;
  if (plan.body_count > 12) {
    // Many freedoms and circuits at once take long.
    plan.usual = std::max(plan.usual, plan.space == Space::planar ? 0.4 : 0.8);
  }
  return plan;
}

CouplingType choose_type(const Plan& plan, Random& random) {
  return random.one_of(random.chance(plan.usual) ? plan.usual_types : plan.types);
}

// A tree of long chains.
std::vector<Branch> make_tree(const Plan& plan, Random& random) {
  std::vector<Branch> branches;
  for (int b = 1; b < plan.body_count; ++b) {
    const int other = random.chance(plan.chained) ? b - 1 : random.whole(0, b - 1);
    branches.push_back({.edge = {.tail = other, .head = b}, .type = choose_type(plan, random)});
  }
  return branches;
}

// Mostly between bodies that have one coupling only, so that motion is in long circuits and not in
// loose ends.
Edge choose_chord(int body_count, const std::vector<Branch>& branches, Random& random) {
  std::vector<int> ends;
  for (int b = 0; b < body_count; ++b) {
    const auto joins = [b](const Branch& branch) {
      return branch.edge.tail == b || branch.edge.head == b;
    };
    if (std::ranges::count_if(branches, joins) == 1) {
      ends.push_back(b);
    }
  }
  const int any = random.whole(0, body_count - 1);
  const int tail = ends.empty() || random.chance(0.2) ? any : random.one_of(ends);
  std::erase(ends, tail);
  const int other = (tail + random.whole(1, body_count - 1)) % body_count;
  const int head = ends.empty() || random.chance(0.2) ? other : random.one_of(ends);
  return {.tail = tail, .head = head};
}

// Chords while they leave the mobility, at least one.
std::vector<Branch> make_branches(const Plan& plan, Random& random) {
  std::vector<Branch> branches = make_tree(plan, random);
  const int order = plan.space == Space::planar ? 3 : 6;
  int mobility = 0;
  for (const Branch& branch : branches) {
    mobility += usual_freedoms(branch.type, plan.space);
  }
  for (int i = 0; i < plan.most_chords; ++i) {
    const CouplingType type = choose_type(plan, random);
    const int left = mobility + usual_freedoms(type, plan.space) - order;
    if (i == 0 || left >= plan.least_mobility) {
      branches.push_back({.edge = choose_chord(plan.body_count, branches, random), .type = type});
      mobility = left;
    }
  }
  for (Branch& branch : branches) {
    if (random.chance(0.4)) {
      std::swap(branch.edge.tail, branch.edge.head);
    }
  }
  random.shuffle(branches);
  return branches;
}

// Whether a choice of its constraints is the same in every position of the world: they are listed,
// or chosen by kind.
bool has_listed_constraints(const NetworkCoupling& coupling) {
  return coupling.find("constraints") != nullptr;
}

bool has_own_kinds(const NetworkCoupling& coupling) {
  return coupling.type != CouplingType::screws;
}

std::vector<int> choose_passive(const NetworkCoupling& coupling, bool at_will, Random& random) {
  const bool is_by_kind = !at_will && !has_listed_constraints(coupling);
  const int kind = random.whole(0, has_own_kinds(coupling) ? 2 : 0);
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

void add_passive(const Plan& plan, RandomNetwork& network, Random& random) {
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
void add_actuators(const Plan& plan, RandomNetwork& network, Random& random) {
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
  const bool is_small_spatial = seed >= kFirstSmallSpatialSeed;
  RandomNetwork network;
  network.layout = choose_layout(is_small_spatial, random);
  const Plan plan = make_plan(is_small_spatial, seed % 2 == 0, network.layout, random);
  for (int b = 1; b < plan.body_count; ++b) {
    network.body_order.push_back(b);
  }
  LayoutDraw draw(network.layout, random);
  for (const Branch& branch : make_branches(plan, random)) {
    NetworkCoupling coupling;
    coupling.name = fmt::format("c{}", network.couplings.size());
    coupling.type = branch.type;
    coupling.tail = branch.edge.tail;
    coupling.head = branch.edge.head;
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
