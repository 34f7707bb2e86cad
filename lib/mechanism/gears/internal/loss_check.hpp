// The numbers and references of the section `losses`.
#pragma once

#include "mechanism/check/section_context.hpp"

namespace kinestat {

void check_losses(const SectionContext& context);

}  // namespace kinestat
