// The numbers and references of the section `motion`.
#pragma once

#include "mechanism/check/section_context.hpp"

namespace kinestat {

void check_motion(const SectionContext& context);

}  // namespace kinestat
