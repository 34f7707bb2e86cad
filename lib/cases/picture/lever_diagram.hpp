// Lever diagrams (nomographs) of planetary trains: speeds as distances along a lever.
#pragma once

#include <vector>

#include "cases/analysis.hpp"
#include "draw/picture.hpp"
#include "mechanism/gears/lever_analogy.hpp"

namespace kinestat {

/// Draws one row per case with velocities and one column per lever. A node is drawn at its place
/// along the lever; its distance from the zero line is its angular velocity about the axis of the
/// lever, on one scale for all. Inputs, outputs and engaged elements are marked. There must be at
/// least one lever and one case with velocities.
Picture draw_lever_diagram(const Analysis& analysis, const std::vector<Lever>& levers);

/// Each lever as a picture of its own that fits a telephone, with the label of a case above it.
std::vector<Picture> draw_levers_in_parts(const Analysis& analysis,
                                          const std::vector<Lever>& levers);

}  // namespace kinestat
