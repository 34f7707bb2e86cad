// What bodies weigh and where, and gravity.
#pragma once

#include "mechanism/internal/section_context.hpp"

namespace kinestat {

/// Evaluates mass, centre of mass and outline of every body, and gravity.
void check_bodies(const SectionContext& context);

}  // namespace kinestat
