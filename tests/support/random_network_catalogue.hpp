// The geometry of random couplings, of every type of the catalogue.
#pragma once

#include "support/random_network_draw.hpp"

namespace kinestat {

/// Which couplings a network may have: those with as many freedoms and constraints as the space has
/// dimensions, or all.
enum class Completeness { complementary, any };

/// The types of a space that may be complementary, or all.
std::vector<CouplingType> types_of(Space space, Completeness completeness);

/// How many freedoms a coupling of a type has; of screws and gears how many it has at a guess.
int usual_freedoms(CouplingType type, Space space);

/// The keys of a coupling, without `passive`. What the binder demands of them is met to rounding:
/// lines across normals, lines of action across the sliding of teeth, reciprocal lists of screws.
std::vector<NetworkKey> draw_keys(CouplingType type, Completeness completeness, LayoutDraw& draw);

}  // namespace kinestat
