#include "support/random_network_plan.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace kinestat {

namespace {

// How large a network is and which types it draws from.
struct Outline {
  Space space = Space::spatial;
  int body_count = 0;
  int most_chords = 0;
  int least_mobility = 0;                 ///< F - λ l; no chord is added that would leave less
  std::vector<CouplingType> types;        ///< drawn alike
  std::vector<CouplingType> usual_types;  ///< of the other couplings; repeated ones more often
  double usual = 0.0;                     ///< share of the others
  double chained = 0.0;                   ///< share of the bodies that follow the one before
};

bool is_small_spatial(std::uint64_t seed) {
  return seed >= kFirstSmallSpatialSeed;
}

Layout choose_layout(std::uint64_t seed, Random& random) {
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
  return kShares[static_cast<std::size_t>(is_small_spatial(seed) ? random.whole(3, 10)
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

Outline make_outline(std::uint64_t seed, Layout layout, Completeness completeness, Random& random) {
  Outline outline;
  outline.space = layout == Layout::planar ? Space::planar : Space::spatial;
  outline.usual_types = usual_types_of(layout, completeness);
  outline.types = choose_types(outline.space, completeness, random);
  outline.usual = random.chance(0.3) ? 1.0 : random.between(0.2, 0.6);
  outline.chained = random.chance(0.4) ? 1.0 : 0.7;
  if (is_small_spatial(seed)) {
    outline.body_count = random.whole(3, random.chance(0.5) ? 6 : 12);
    outline.most_chords = outline.body_count;
    outline.least_mobility = random.whole(-2, 2);
    return outline;
  }
  // Small networks are as likely as large ones, because special cases live there.
  outline.body_count = random.chance(0.5) ? random.whole(3, 8) : random.whole(9, 30);
  const int most = outline.body_count / (outline.space == Space::planar ? 3 : 5);
  outline.most_chords = random.whole(1, 1 + most);
  outline.least_mobility = -6 * most;
  if (outline.body_count > 12) {
    // Many freedoms and circuits at once take long.
    outline.usual = std::max(outline.usual, outline.space == Space::planar ? 0.4 : 0.8);
  }
  return outline;
}

CouplingType choose_type(const Outline& outline, Random& random) {
  return random.one_of(random.chance(outline.usual) ? outline.usual_types : outline.types);
}

// A tree of long chains.
std::vector<PlannedCoupling> make_tree(const Outline& outline, Random& random) {
  std::vector<PlannedCoupling> couplings;
  for (int b = 1; b < outline.body_count; ++b) {
    const int other = random.chance(outline.chained) ? b - 1 : random.whole(0, b - 1);
    couplings.push_back({.edge = {.tail = other, .head = b}, .type = choose_type(outline, random)});
  }
  return couplings;
}

// Mostly between bodies that have one coupling only, so that motion is in long circuits and not in
// loose ends.
Edge choose_chord(int body_count, const std::vector<PlannedCoupling>& couplings, Random& random) {
  std::vector<int> ends;
  for (int b = 0; b < body_count; ++b) {
    const auto joins = [b](const PlannedCoupling& coupling) {
      return coupling.edge.tail == b || coupling.edge.head == b;
    };
    if (std::ranges::count_if(couplings, joins) == 1) {
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
std::vector<PlannedCoupling> plan_couplings(const Outline& outline, Random& random) {
  std::vector<PlannedCoupling> couplings = make_tree(outline, random);
  const int order = outline.space == Space::planar ? 3 : 6;
  int mobility = 0;
  for (const PlannedCoupling& coupling : couplings) {
    mobility += usual_freedoms(coupling.type, outline.space);
  }
  for (int i = 0; i < outline.most_chords; ++i) {
    const CouplingType type = choose_type(outline, random);
    const int left = mobility + usual_freedoms(type, outline.space) - order;
    if (i == 0 || left >= outline.least_mobility) {
      couplings.push_back(
          {.edge = choose_chord(outline.body_count, couplings, random), .type = type});
      mobility = left;
    }
  }
  for (PlannedCoupling& coupling : couplings) {
    if (random.chance(0.4)) {
      std::swap(coupling.edge.tail, coupling.edge.head);
    }
  }
  random.shuffle(couplings);
  return couplings;
}

}  // namespace

NetworkPlan make_network_plan(std::uint64_t seed, Random& random) {
  NetworkPlan plan;
  plan.layout = choose_layout(seed, random);
  plan.completeness = seed % 2 == 0 ? Completeness::complementary : Completeness::any;
  const Outline outline = make_outline(seed, plan.layout, plan.completeness, random);
  plan.body_count = outline.body_count;
  plan.couplings = plan_couplings(outline, random);
  plan.actuated = random.chance(0.5) ? 1.0 : random.between(0.2, 0.8);
  plan.names_world = random.chance(0.2);
  return plan;
}

}  // namespace kinestat
