// The numbers and references of the section `sweep`.
#pragma once

#include "mechanism/check/section_context.hpp"

namespace kinestat {

/// Complains of ranges that never end and of sweeps that are too large, too.
void check_sweep(const SectionContext& context);

}  // namespace kinestat
