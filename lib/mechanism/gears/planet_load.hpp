// The loads of couplings from several equal planets, of which one is drawn.
#pragma once

#include "core/diagnostic.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// The number of equal planets that share the action of a coupling; 1 for any other coupling.
int planets_of(const Mechanism& mechanism, const CouplingTopology& coupling);

/// The share of the most loaded of these planets in the action of all; 1 for any other coupling.
double most_loaded_share(const Mechanism& mechanism, const CouplingTopology& coupling);

/// Sets what planets change in the frictions, once the cases have their loads. Adds W0315 if
/// further hinges share what a central one bears: its friction then includes that of one planet.
void settle_planet_frictions(Mechanism& mechanism, Diagnostics& found);

}  // namespace kinestat
