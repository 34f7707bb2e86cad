// The numbers and references of the section `shift`.
#pragma once

#include "mechanism/check/section_context.hpp"

namespace kinestat {

/// Complains of elements and labels that contradict each other, too.
void check_shift(const SectionContext& context);

}  // namespace kinestat
