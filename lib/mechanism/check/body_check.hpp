// What is drawn of bodies.
#pragma once

#include "mechanism/check/section_context.hpp"

namespace kinestat {

/// Evaluates the outline of every body.
void check_bodies(const SectionContext& context);

}  // namespace kinestat
