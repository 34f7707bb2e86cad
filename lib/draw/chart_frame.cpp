#include "draw/chart_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/contract.hpp"

namespace kinestat {

namespace {

constexpr double kFreeHeight = 210.0;  // of the frame, if scales are free
constexpr double kTallest = 560.0;     // likewise, if they are equal

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value, ScaleKind kind) {
    if (std::isfinite(value) && (kind == ScaleKind::linear || value > 0.0)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }

  bool is_empty() const { return low > high; }
};

// Of the lines as they are drawn, and of the points worth words.
Range range_of(const Chart& chart,
               const ChartAxis& axis,
               std::vector<double> Series::*values,
               double ChartMark::*value_of_mark) {
  Range range;
  for (const Series& series : chart.series) {
    const Series drawn = drawn_series(series);
    for (const double value : drawn.*values) {
      range.add(value, axis.scale);
    }
  }
  for (const ChartMark& mark : chart.marks) {
    range.add(mark.*value_of_mark, axis.scale);
  }
  return range;
}

AxisRange axis_range(const ChartAxis& axis, Range range, double pixels, double tick_distance) {
  if (range.is_empty()) {
    range = {.low = 1.0, .high = 10.0};
  }
  const AxisDemand demand = {.low = axis.low.value_or(range.low),
                             .high = axis.high.value_or(range.high),
                             .tick_count = static_cast<int>(pixels / tick_distance),
                             .in_degrees = axis.unit == "deg",
                             .least_step = axis.least_step};
  if (axis.scale == ScaleKind::logarithmic) {
    return logarithmic_axis(demand);
  }
  return axis.low || axis.high ? tight_axis(demand) : linear_axis(demand);
}

// Both axes with the same pixels a unit, and a frame that the data fill.
ChartFrame equal_frame(const Chart& chart, double top) {
  const Range x = range_of(chart, chart.x, &Series::x, &ChartMark::x);
  const Range y = range_of(chart, chart.y, &Series::y, &ChartMark::y);
  const double size =
      std::max({std::abs(x.low), std::abs(x.high), std::abs(y.low), std::abs(y.high)});
  const double largest = shown_span(std::max(x.high - x.low, y.high - y.low), size);
  const double step_count = 6.0;
  const AxisDemand both = {.low = 0.0, .high = largest, .tick_count = static_cast<int>(step_count)};
  const double step = linear_axis(both).ticks[1].value;
  const auto along = [step](const Range& range) {
    // At least a step wide, so that a straight path has a frame.
    const double low = std::floor(range.low / step) * step;
    const double high = std::max(std::ceil(range.high / step) * step, low + step);
    const int count = static_cast<int>(std::lround((high - low) / step));
    return tight_axis({.low = low, .high = high, .tick_count = count});
  };
  ChartFrame frame = {.box = {}, .x = along(x), .y = along(y)};
  const double width = frame.x.high - frame.x.low;
  const double height = frame.y.high - frame.y.low;
  const double scale = std::min(chart.width / width, kTallest / height);
  frame.box = {.left = 0.0, .top = top, .right = width * scale, .bottom = top + height * scale};
  return frame;
}

ChartFrame free_frame(const Chart& chart, double top) {
  return {.box = {.left = 0.0, .top = top, .right = chart.width, .bottom = top + kFreeHeight},
          .x = axis_range(chart.x,
                          range_of(chart, chart.x, &Series::x, &ChartMark::x),
                          chart.width,
                          std::min(80.0, chart.width / 5)),
          .y = axis_range(
              chart.y, range_of(chart, chart.y, &Series::y, &ChartMark::y), kFreeHeight, 38.0)};
}

// Answers how far the labels reach to the left.
double draw_tick_labels(const ChartFrame& frame, Svg& svg) {
  TextStyle style = {.ink = Ink::soft, .size = kTickText, .anchor = Anchor::middle};
  for (const Tick& tick : frame.x.ticks) {
    const double x = frame.place(tick.value, frame.y.low).x;
    svg.text({.x = x, .y = frame.box.bottom + 15.0}, tick.label, style);
  }
  style.anchor = Anchor::end;
  double reach = 0.0;
  for (const Tick& tick : frame.y.ticks) {
    const double y = frame.place(frame.x.low, tick.value).y;
    svg.text({.x = frame.box.left - 6.0, .y = y + 4.0}, tick.label, style);
    reach = std::max(reach, text_width(tick.label, kTickText));
  }
  return reach + 6.0;
}

void draw_axis_titles(const Chart& chart, const ChartFrame& frame, double reach, Svg& svg) {
  const TextStyle style = {.size = kChartText, .anchor = Anchor::middle};
  svg.text({.x = frame.box.centre().x, .y = frame.box.bottom + 33.0},
           axis_title(chart.x, frame.x.exponent),
           style);
  const std::string title = axis_title(chart.y, frame.y.exponent);
  // Along the axis; above it where the axis is too short.
  if (text_width(title, kChartText) <= frame.box.height() + 20.0) {
    TextStyle turned = style;
    turned.turn = -90.0;
    svg.text({.x = frame.box.left - reach - 10.0, .y = frame.box.centre().y}, title, turned);
  } else {
    const double y = frame.box.top - frame.words_above - 8.0;
    svg.text({.x = frame.box.left, .y = y}, title, {.size = kChartText});
  }
}

}  // namespace

bool ChartFrame::holds(PixelPoint point) const {
  const PixelBox outer = box.grown(0.5);
  return point.x >= outer.left && point.x <= outer.right && point.y >= outer.top &&
         point.y <= outer.bottom;
}

bool has_data(const Chart& chart) {
  return !range_of(chart, chart.x, &Series::x, &ChartMark::x).is_empty() &&
         !range_of(chart, chart.y, &Series::y, &ChartMark::y).is_empty();
}

ChartFrame make_frame(const Chart& chart, double top) {
  return chart.has_equal_scales ? equal_frame(chart, top) : free_frame(chart, top);
}

void draw_grid(const ChartFrame& frame, Svg& svg) {
  const Paint grid = {.stroke = Ink::grid, .width = 1.0};
  for (const Tick& tick : frame.x.ticks) {
    const double x = frame.place(tick.value, frame.y.low).x;
    svg.line({.x = x, .y = frame.box.top}, {.x = x, .y = frame.box.bottom}, grid);
  }
  for (const Tick& tick : frame.y.ticks) {
    const double y = frame.place(frame.x.low, tick.value).y;
    svg.line({.x = frame.box.left, .y = y}, {.x = frame.box.right, .y = y}, grid);
  }
  const Paint axis = {.stroke = Ink::soft, .width = 1.0};
  const bool has_zero =
      frame.y.kind == ScaleKind::linear && frame.y.low < 0.0 && frame.y.high > 0.0;
  if (has_zero) {
    const double y = frame.place(frame.x.low, 0.0).y;
    svg.line({.x = frame.box.left, .y = y}, {.x = frame.box.right, .y = y}, axis);
  }
  svg.rectangle(frame.box, axis);
}

void draw_axes(const Chart& chart, const ChartFrame& frame, Svg& svg) {
  draw_axis_titles(chart, frame, draw_tick_labels(frame, svg), svg);
}

namespace {

std::vector<PixelPoint> corners(int shape, PixelPoint at, double r) {
  switch (shape) {
    case 1:
      return {{.x = at.x - r, .y = at.y - r},
              {.x = at.x + r, .y = at.y - r},
              {.x = at.x + r, .y = at.y + r},
              {.x = at.x - r, .y = at.y + r}};
    case 2:
      return {{.x = at.x, .y = at.y - 1.2 * r},
              {.x = at.x + 1.1 * r, .y = at.y + 0.8 * r},
              {.x = at.x - 1.1 * r, .y = at.y + 0.8 * r}};
    default:
      return {{.x = at.x, .y = at.y - 1.3 * r},
              {.x = at.x + 1.3 * r, .y = at.y},
              {.x = at.x, .y = at.y + 1.3 * r},
              {.x = at.x - 1.3 * r, .y = at.y}};
  }
}

}  // namespace

void draw_marker(int shape, PixelPoint place, Ink ink, double size, Svg& svg) {
  KINESTAT_EXPECTS(shape >= 0);
  const int kind = shape % kMarkerShapes;
  const bool is_hollow = kind >= kMarkerShapes / 2;
  const Paint paint = {.stroke = ink, .fill = is_hollow ? Ink::paper : ink, .width = 1.5};
  const double r = size / 2;
  if (kind % 4 == 0) {
    svg.circle(place, 1.1 * r, paint);
  } else {
    svg.polygon(corners(kind % 4, place, r), paint);
  }
}

}  // namespace kinestat
