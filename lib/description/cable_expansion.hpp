// What cables, belts and chains add to the bodies and couplings of a mechanism.
#pragma once

#include "description/mechanism_description.hpp"

namespace kinestat {

/// Appends, for each cable in the order of the file, a coupling of type `cable` for each straight
/// segment, then for each slipping pulley a virtual link and the revolute coupling on which it
/// turns, coaxial with the pulley (Alves 2023, chapter 3). The segments end on the virtual link, or
/// on the pulley itself where the cable does not slip.
///
/// To be done once, after reading. A cable is left out if the file does not declare its bodies,
/// joins a body to itself, lacks the centre of a pulley or has taken a name that the cable makes:
/// binding complains of all these.
void expand_cables(MechanismDescription& description);

/// Whether all cables have been expanded, or there are none.
bool is_expanded(const MechanismDescription& description);

/// The same without what the cables added.
MechanismDescription without_cable_parts(const MechanismDescription& description);

}  // namespace kinestat
