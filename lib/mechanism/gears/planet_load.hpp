// The loads of couplings from several equal planets, of which one is drawn.
#pragma once

#include <optional>
#include <vector>

#include "core/diagnostic.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// The number of equal planets that share the action of a coupling; 1 for any other coupling.
int planets_of(const Mechanism& mechanism, const CouplingTopology& coupling);

/// The share of the most loaded of these planets in the action of all; 1 for any other coupling.
double most_loaded_share(const Mechanism& mechanism, const CouplingTopology& coupling);

/// A hinge on the axis of carriers of several equal planets, or of suns and rings that mesh with
/// them. Equal planets at equal angles press it from all sides, so that their radial forces cancel;
/// but as drawn, it bears the radial force of one planet in the place of all. Axial forces and
/// moments about the axis add up.
struct CentralHinge {
  Vec3 axis = Vec3::UnitZ();  ///< a unit vector, as drawn
  bool bears_more = false;    ///< whether other couplings or loads also press the bodies of its
                              ///< line across the axis
};

/// Finds the central hinge of each coupling; empty for couplings that are none.
std::vector<std::optional<CentralHinge>> find_central_hinges(const Mechanism& mechanism);

/// Sets `planets` and `is_balanced` of the frictions, once the cases have their loads. Adds W0315
/// if a central hinge also bears other forces: its friction then includes that of the planets.
void settle_planet_frictions(Mechanism& mechanism, Diagnostics& found);

}  // namespace kinestat
