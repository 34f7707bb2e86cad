// What several equal planets do to the couplings that bear them, where one is drawn.
#pragma once

#include <optional>
#include <vector>

#include "core/diagnostic.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// How many equal planets share what a coupling bears; 1 of all others.
int planets_of(const Mechanism& mechanism, const CouplingTopology& coupling);

/// What the most loaded of these planets bears, as a share of what all do; 1 of all others.
double most_loaded_share(const Mechanism& mechanism, const CouplingTopology& coupling);

/// A hinge on the line about which carriers of several equal planets turn, or suns and rings that
/// mesh with these. Across the axis it bears as drawn what one planet in the place of all would
/// press it with, while equal planets at equal angles press from all sides; what acts along and
/// about the axis adds up.
struct CentralHinge {
  Vec3 axis = Vec3::UnitZ();  ///< a unit vector, as drawn
  bool bears_more = false;    ///< other couplings or loads than planets act on the bodies of its
                              ///< line, which press it across the axis as well
};

/// Of each coupling; empty for those that are none.
std::vector<std::optional<CentralHinge>> find_central_hinges(const Mechanism& mechanism);

/// Sets `planets` and `is_balanced` of the frictions, once cases have their loads. W0315 where a
/// central hinge bears more than planets, so that what these press it with as drawn counts too.
void settle_planet_frictions(Mechanism& mechanism, Diagnostics& found);

}  // namespace kinestat
