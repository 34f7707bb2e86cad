// The numbers and references of the section `cables`.
#pragma once

#include "mechanism/internal/section_context.hpp"

namespace kinestat {

/// Complains of pulleys without a centre and of segments that join a body to itself, too.
void check_cables(const SectionContext& context);

}  // namespace kinestat
