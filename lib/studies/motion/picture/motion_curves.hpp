// Curves of a finite motion: what its positions have against time or drive, and the paths of
// points.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "draw/chart.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// One chart a quantity and unit, such as position, velocity or transmission angle, with a series
/// for each element, against a column of the table, by itself that of `usual_abscissa`. Guides
/// stand where a freedom comes to rest, where the motion is singular and where a drive goes no
/// further; of few series the extremes are marked. Places of points are left to `path_figure`,
/// unless they are named one by one. No charts if there is nothing else.
Figure motion_figure(const MotionTable& motion,
                     const std::string& title,
                     std::optional<std::size_t> column = {});

/// The paths of the traced points or, without any, of the reference points of the bodies, in the
/// planes in which they lie: y over x, and z over x where z changes. No charts without places.
Figure path_figure(const MotionTable& motion, const std::string& title);

}  // namespace kinestat
