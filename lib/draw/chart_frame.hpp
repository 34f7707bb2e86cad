// The frame of a chart on a picture: where values stand, its grid, the words at its axes, and
// marks.
#pragma once

#include "draw/chart.hpp"
#include "draw/svg.hpp"

namespace kinestat {

inline constexpr double kChartText = 12.0;  ///< size of names [px]
inline constexpr double kTickText = 11.0;   ///< size of numbers [px]

/// The axes along a box on the picture.
struct ChartFrame {
  PixelBox box;
  AxisRange x;
  AxisRange y;
  double words_above = 0.0;  ///< height of what is written over the box [px]

  PixelPoint place(double x_value, double y_value) const {
    return {.x = box.left + x.share(x_value) * box.width(),
            .y = box.bottom - y.share(y_value) * box.height()};
  }

  /// Whether a point of the picture is in the box or on its rim.
  bool holds(PixelPoint point) const;
};

/// Whether a chart has any point that can be drawn.
bool has_data(const Chart& chart);

/// The frame whose top is there, around all data.
ChartFrame make_frame(const Chart& chart, double top);

/// Behind the data.
void draw_grid(const ChartFrame& frame, Svg& svg);

/// Numbers and titles of both axes.
void draw_axes(const Chart& chart, const ChartFrame& frame, Svg& svg);

/// How many shapes there are; then they begin again.
inline constexpr int kMarkerShapes = 8;

/// The n-th shape at a place: disc, square, triangle, diamond, then the same hollow.
void draw_marker(int shape, PixelPoint place, Ink ink, double size, Svg& svg);

}  // namespace kinestat
