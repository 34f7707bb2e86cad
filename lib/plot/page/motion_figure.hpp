// A finite motion on a page: a drawing that a script moves, and its positions.
#pragma once

#include <string>

#include "plot/file_page.hpp"
#include "plot/page/html.hpp"
#include "report/table.hpp"

namespace kinestat {

/// Adds the drawing with the paths of the traced points; of a planar mechanism also a slider and a
/// button, which a script brings to life, and the poses of all bodies for it. Ids begin with `id`;
/// `figures` counts on. There must be a pose.
void add_motion_figure(const Analysis& analysis,
                       const PageMotion& motion,
                       const std::string& id,
                       int& figures,
                       Html& html);

/// All positions with everything that is reported of them.
Table position_table(const MotionTable& motion);

}  // namespace kinestat
