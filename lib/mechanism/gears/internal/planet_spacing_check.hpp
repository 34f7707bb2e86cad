// Whether several equal planets have room and can be assembled.
#pragma once

#include "mechanism/check/section_context.hpp"
#include "mechanism/gears/gear_layout.hpp"

namespace kinestat {

/// Warns of planets with a `count` that cannot be spaced equally (W0306) or whose tip circles meet
/// (W0307): of one planet, and of planets that mesh with each other, from one set to the next. Tips
/// are one module outside the pitch circle.
void check_planet_spacing(const SectionContext& context,
                          const GearNumbers& numbers,
                          const GearLayout& layout);

}  // namespace kinestat
