// Whether cables, belts and chains can run as they are drawn.
#pragma once

#include "mechanism/check/section_context.hpp"

namespace kinestat {

/// Complains of segments that no tangent can follow and of those that pass through a pulley of the
/// same cable in the same plane, pulleys coaxial with one of its ends excepted: they stand side by
/// side. False also if the numbers of a station are wrong elsewhere, or a cable has not been
/// expanded.
bool check_routes(const SectionContext& context);

}  // namespace kinestat
