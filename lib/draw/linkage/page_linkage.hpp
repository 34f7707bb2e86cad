// The drawing of a mechanism as wide as a page wants it.
#pragma once

#include "draw/linkage/linkage_drawing.hpp"

namespace kinestat {

/// As draw_linkage, but for LinkageOptions::width: so that it shrinks to a telephone, as long as
/// its names have room then; else as wide as elsewhere.
Picture draw_page_linkage(const Analysis& analysis, LinkageOptions options = {});

}  // namespace kinestat
