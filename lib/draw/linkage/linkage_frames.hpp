// What of a mechanism no matrix moves, drawn anew for every position of a motion.
#pragma once

#include "draw/linkage/linkage_canvas.hpp"

namespace kinestat {

/// Draws a part of a mechanism as it stands on the canvas.
using FrameWriter = void (*)(const Analysis& analysis,
                             const LinkageOptions& options,
                             const LinkageParts& parts,
                             LinkageCanvas& canvas);

/// Adds a group `data-frame` to the canvas for each of LinkageOptions::frames, in its view: hidden,
/// or seen as LinkageOptions::cycle says.
void draw_linkage_frames(const Analysis& analysis,
                         const LinkageOptions& options,
                         LinkageCanvas& canvas,
                         FrameWriter write);

/// Adds the mechanism as it stands in all but the first of LinkageOptions::stands, so that it shows
/// faintly; `drawn` is as in the file.
void draw_faint_positions(const Analysis& drawn,
                          const LinkageOptions& options,
                          LinkageCanvas& canvas,
                          FrameWriter write);

}  // namespace kinestat
