// The numbers and references of the section `gears`.
#pragma once

#include "mechanism/internal/section_context.hpp"

namespace kinestat {

/// Complains of teeth that are no teeth, of meshes that cannot be, and of what is missing; warns of
/// members without a mesh.
void check_gears(const SectionContext& context);

}  // namespace kinestat
