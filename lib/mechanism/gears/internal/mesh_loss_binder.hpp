// The section `losses`: its numbers and references, and what it makes of the meshes.
#pragma once

#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/check/section_context.hpp"
#include "mechanism/gears/lossy_mesh.hpp"

namespace kinestat {

/// The numbers and references of the section `losses`.
void check_losses(const SectionContext& context);

/// The meshes that lose anything, in the order of the couplings: each has the loss that 'meshes:'
/// gives for it, or else that of its kind. The section must be there and all numbers be right;
/// complains of teeth that a mesh does not have, or that leave nothing of its power.
std::vector<LossyMesh> bind_losses(const MechanismDescription& description,
                                   Evaluator& evaluator,
                                   Diagnostics& found);

}  // namespace kinestat
