// A column of a motion as the line of a chart.
#pragma once

#include <cstddef>

#include "draw/chart.hpp"
#include "studies/motion/picture/motion_abscissa.hpp"

namespace kinestat {

/// A point a row. Between them the line leads through what is known there: the column's extremes
/// where those of `over` are known, its value at events, and either side of a jump, with a gap
/// between the two. It is called as the element of the column.
Series motion_line(const MotionTable& motion, const MotionAbscissa& over, std::size_t column);

}  // namespace kinestat
