// What a script needs to draw a spatial mechanism from any side.
#pragma once

#include <string>
#include <vector>

#include "cases/analysis.hpp"
#include "draw/linkage/linkage_drawing.hpp"
#include "pages/html.hpp"

namespace kinestat {

/// Adds the data of a drawing of draw_linkage, which may be turned then: an element `script` with
/// that id. At each position, or as drawn where there are none, it has the points of each body, the
/// places and axes of couplings, wheels and straight parts of cables [m]; for all of them the
/// paths.
void add_spatial_scene(const Analysis& analysis,
                       const std::vector<LinkagePosition>& positions,
                       const std::vector<TracedPath>& paths,
                       const std::string& id,
                       Html& html);

}  // namespace kinestat
