// The numbers and references of the section `cables`.
#pragma once

#include "mechanism/check/section_context.hpp"

namespace kinestat {

/// Complains of pulleys without a centre, of segments that join a body to itself and of cables that
/// cannot run as they are drawn, too. False if the couplings that the cables make cannot be bound,
/// for which there may be other reasons; they have their own complaints.
bool check_cables(const SectionContext& context);

}  // namespace kinestat
