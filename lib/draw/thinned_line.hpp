// Lines without the points that nobody sees.
#pragma once

#include <span>
#include <vector>

#include "draw/pixel_box.hpp"

namespace kinestat {

/// Of a line the points that hold it within a tenth of a pixel, its ends among them. All points
/// must be finite.
std::vector<PixelPoint> thinned_line(std::span<const PixelPoint> points);

}  // namespace kinestat
