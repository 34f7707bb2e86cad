// The numbers and references of `loads`, at the top level and in cases.
#pragma once

#include "mechanism/internal/section_context.hpp"

namespace kinestat {

void check_loads(const SectionContext& context);

}  // namespace kinestat
