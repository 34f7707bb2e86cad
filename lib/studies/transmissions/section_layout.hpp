// Whether the shafts of a transmission can be arranged around one axis.
//
// In the half plane above the axis a shaft is a connected region: a vertex. A set is a path from
// its sun over the carrier, on which the planet sits, to its ring; an element is an edge. Where no
// two regions cross, the graph is planar. Coaxial input and output end on the axis, as the housing
// does: a vertex more, which the three border. Where a gear or chain takes the drive off sideways,
// input and output border the housing instead. What passes between a sun and the axis makes the
// shaft of the sun hollow; where nothing does, an edge more leads from the sun down to the axis.
#pragma once

#include <cstdint>
#include <optional>

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

/// How many shafts have a sun of which the set is passed below by another shaft, in the drawing of
/// the section in which they are fewest. The housing is no shaft. Empty where the layout is `any`,
/// which has no axis; where the section cannot be drawn the number means nothing.
std::optional<std::uint64_t> least_hollow_shafts(const TransmissionStructure& structure,
                                                 const RoleChoice& choice,
                                                 const ElementPlacement& elements,
                                                 SectionLayout layout);

}  // namespace kinestat
