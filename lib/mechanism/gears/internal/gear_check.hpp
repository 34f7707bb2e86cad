// The numbers and references of the section `gears`.
#pragma once

#include "mechanism/check/section_context.hpp"

namespace kinestat {

/// Complains of teeth that are no teeth, of meshes that cannot be, and of what is missing; warns of
/// members without a mesh, and of what check_gear_train finds. False after an error: then the
/// couplings that meshes became cannot be bound.
bool check_gears(const SectionContext& context);

}  // namespace kinestat
