// The drawing of a planar mechanism.
#pragma once

#include "draw/linkage/linkage_canvas.hpp"

namespace kinestat {

/// Fills the canvas, whose view looks along -z with y upwards.
void draw_planar(const Analysis& analysis,
                 const LinkageOptions& options,
                 const LinkageParts& parts,
                 LinkageCanvas& canvas);

}  // namespace kinestat
