// The drawing of a finite motion, which a script moves.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pages/file_page.hpp"
#include "pages/html.hpp"

namespace kinestat {

/// Of that many positions those that a page draws, the first and the last among them: more would
/// look no smoother or, of what is drawn anew for each, make the page too long.
std::vector<std::size_t> shown_positions(const Mechanism& mechanism, std::size_t count);

/// What a drawing is called, and how it is told from others.
struct MovingDrawingName {
  std::string name;     ///< "motion" or "simulation", of which the rows are
  std::string section;  ///< ids begin with it, and charts that follow name it
};

/// Adds the drawing with the paths of the traced points, a slider and a button, which a script
/// brings to life, and for it the poses of all bodies or, of a spatial mechanism, drawings of the
/// positions. Nothing is shown that is no position of the motion. A simulation begins again after
/// its end, however that stands. `figures` counts on. There must be a position.
void add_motion_figure(const Analysis& analysis,
                       const PageMotion& motion,
                       const MovingDrawingName& as,
                       int& figures,
                       Html& html);

}  // namespace kinestat
