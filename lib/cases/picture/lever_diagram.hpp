// Lever diagrams (nomographs) of planetary trains: speeds as distances along a lever.
#pragma once

#include <vector>

#include "cases/analysis.hpp"
#include "draw/picture.hpp"
#include "mechanism/gears/lever_analogy.hpp"

namespace kinestat {

/// One row a case that has velocities, one column a lever: nodes stand at their places on the
/// lever, their angular velocity about the axis of the lever is the distance from the ground line,
/// on one scale for all. Marked are inputs, outputs and engaged elements. There must be a lever and
/// a case with velocities.
Picture draw_lever_diagram(const Analysis& analysis, const std::vector<Lever>& levers);

}  // namespace kinestat
