// The section `losses` bound to the meshes.
#pragma once

#include <vector>

#include "description/mechanism_description.hpp"
#include "mechanism/internal/evaluator.hpp"
#include "mechanism/lossy_mesh.hpp"

namespace kinestat {

/// The meshes that lose anything, in the order of the couplings: each has the loss that 'meshes:'
/// gives for it, or else that of its kind. The section, if there is one, must be right.
std::vector<LossyMesh> bind_losses(const MechanismDescription& description, Evaluator& evaluator);

}  // namespace kinestat
