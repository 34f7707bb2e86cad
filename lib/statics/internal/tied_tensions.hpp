// Tensions of cables that slip on pulleys, each tied to another one as a share of it.
#pragma once

#include <span>
#include <vector>

#include "statics/equilibrium.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

/// Which tension along a cable the others are multiples of. With very large multiples one of them
/// may leave equations that a rank decision takes for singular.
enum class TiedTo { least, greatest };

/// Whether the friction is that of a cable which slips on a pulley and that nothing else holds
/// back, unless by a known action of zero: then the tension behind is a share of that ahead.
bool is_tied(const Mechanism& mechanism,
             std::span<const Primary> primaries,
             const FrictionLaw& law);

/// The tensions that cables of these laws tie to one of them, or to one that is a primary. None
/// where cables close a circle of slip, or two tensions of one are primaries.
std::vector<TiedTension> find_ties(const Mechanism& mechanism,
                                   std::span<const Primary> primaries,
                                   std::span<const FrictionLaw> laws,
                                   TiedTo to);

}  // namespace kinestat
