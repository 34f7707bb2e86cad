// The numbers of the section `synthesis`.
#pragma once

#include "mechanism/check/section_context.hpp"

namespace kinestat {

/// Complains of a task that no linkage can fulfil by its count of positions, too.
void check_synthesis(const SectionContext& context);

}  // namespace kinestat
