// Whether the shafts of a transmission can be arranged around one axis.
//
// In the half plane above the axis a shaft is a connected region: a vertex. A set is a path from
// its sun over the carrier, on which the planet sits, to its ring; an element is an edge. Where no
// two regions cross, the graph is planar. Coaxial input and output end on the axis, as the housing
// does: a vertex more, which the three border. Where a gear or chain takes the drive off sideways,
// input and output border the housing instead.
#pragma once

#include "studies/transmissions/layouts.hpp"
#include "studies/transmissions/roles.hpp"
#include "studies/transmissions/transmission_task.hpp"

namespace kinestat {

/// Whether the section can be drawn without crossings, which is necessary to build it. Planets on
/// one carrier stand side by side: their chords from sun to ring do not cross there.
bool can_be_arranged(const TransmissionStructure& structure,
                     const RoleChoice& choice,
                     const ElementPlacement& elements,
                     SectionLayout layout);

}  // namespace kinestat
