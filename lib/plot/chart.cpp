#include "plot/chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "plot/labels.hpp"
#include "plot/marker.hpp"

namespace kinestat {

namespace {

constexpr double kWidth = 720.0;    // of the frame of a chart
constexpr double kHeight = 210.0;   // likewise, if scales are free
constexpr double kTallest = 560.0;  // likewise, if they are equal
constexpr double kTextSize = 12.0;
constexpr double kTickSize = 11.0;
constexpr double kLineHeight = 17.0;
constexpr double kSample = 26.0;  // length of a line in the legend
constexpr double kSeen = 0.4;     // nearer points of a line are one
constexpr int kMostLabelled = 40;

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

Range range_of(const Chart& chart, const ChartAxis& axis, std::vector<double> Series::*values) {
  Range range;
  for (const Series& series : chart.series) {
    for (const double value : series.*values) {
      range.add(value, axis.scale);
    }
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
                             .in_degrees = axis.unit == "deg"};
  if (axis.scale == ScaleKind::logarithmic) {
    return logarithmic_axis(demand);
  }
  return axis.low || axis.high ? tight_axis(demand) : linear_axis(demand);
}

// The frame of a chart on the picture, with the axes along it.
struct Frame {
  PixelBox box;
  AxisRange x;
  AxisRange y;

  PixelPoint place(double x_value, double y_value) const {
    return {.x = box.left + x.share(x_value) * box.width(),
            .y = box.bottom - y.share(y_value) * box.height()};
  }
};

// Both axes with the same pixels a unit, and a frame that the data fill.
Frame equal_frame(const Chart& chart, double top) {
  const Range x = range_of(chart, chart.x, &Series::x);
  const Range y = range_of(chart, chart.y, &Series::y);
  const double largest =
      std::max({x.high - x.low, y.high - y.low, std::numeric_limits<double>::min()});
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
  Frame frame = {.box = {}, .x = along(x), .y = along(y)};
  const double width = frame.x.high - frame.x.low;
  const double height = frame.y.high - frame.y.low;
  const double scale = std::min(kWidth / width, kTallest / height);
  frame.box = {.left = 0.0, .top = top, .right = width * scale, .bottom = top + height * scale};
  return frame;
}

Frame free_frame(const Chart& chart, double top) {
  return {.box = {.left = 0.0, .top = top, .right = kWidth, .bottom = top + kHeight},
          .x = axis_range(chart.x, range_of(chart, chart.x, &Series::x), kWidth, 80.0),
          .y = axis_range(chart.y, range_of(chart, chart.y, &Series::y), kHeight, 38.0)};
}

bool has_data(const Chart& chart) {
  return !range_of(chart, chart.x, &Series::x).is_empty() &&
         !range_of(chart, chart.y, &Series::y).is_empty();
}

void draw_grid(const Frame& frame, Svg& svg) {
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

// Answers how far the labels reach to the left.
double draw_tick_labels(const Frame& frame, Svg& svg) {
  TextStyle style = {.ink = Ink::soft, .size = kTickSize, .anchor = Anchor::middle};
  for (const Tick& tick : frame.x.ticks) {
    const double x = frame.place(tick.value, frame.y.low).x;
    svg.text({.x = x, .y = frame.box.bottom + 15.0}, tick.label, style);
  }
  style.anchor = Anchor::end;
  double reach = 0.0;
  for (const Tick& tick : frame.y.ticks) {
    const double y = frame.place(frame.x.low, tick.value).y;
    svg.text({.x = frame.box.left - 6.0, .y = y + 4.0}, tick.label, style);
    reach = std::max(reach, text_width(tick.label, kTickSize));
  }
  return reach + 6.0;
}

void draw_axis_titles(const Chart& chart, const Frame& frame, double reach, Svg& svg) {
  const TextStyle style = {.size = kTextSize, .anchor = Anchor::middle};
  svg.text({.x = frame.box.centre().x, .y = frame.box.bottom + 33.0},
           axis_title(chart.x, frame.x.exponent),
           style);
  const std::string title = axis_title(chart.y, frame.y.exponent);
  // Along the axis; above it where the axis is too short.
  if (text_width(title, kTextSize) <= frame.box.height() + 20.0) {
    TextStyle turned = style;
    turned.turn = -90.0;
    svg.text({.x = frame.box.left - reach - 10.0, .y = frame.box.centre().y}, title, turned);
  } else {
    svg.text({.x = frame.box.left, .y = frame.box.top - 8.0}, title, {.size = kTextSize});
  }
}

// Points of a line that can be told apart on the picture, with its gaps; what lies outside the
// frame is a gap too.
std::vector<PixelPoint> visible_points(const Frame& frame, const Series& series) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  const PixelBox within = frame.box.grown(0.5);
  std::vector<PixelPoint> points;
  const auto is_gap = [](const PixelPoint& point) { return !std::isfinite(point.x); };
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const PixelPoint point = frame.place(series.x[i], series.y[i]);
    const bool is_visible = point.x >= within.left && point.x <= within.right &&
                            point.y >= within.top && point.y <= within.bottom;
    if (!is_visible) {
      if (!points.empty() && !is_gap(points.back())) {
        points.push_back({.x = kGap, .y = kGap});
      }
      continue;
    }
    const bool is_near = !points.empty() && !is_gap(points.back()) &&
                         std::hypot(point.x - points.back().x, point.y - points.back().y) < kSeen;
    const bool is_last = i + 1 == series.x.size();
    if (!is_near || is_last || series.style == SeriesStyle::points) {
      points.push_back(point);
    }
  }
  return points;
}

Paint line_paint(int index) {
  return {.stroke = series_ink(index), .width = 2.0, .dash = std::string(series_dash(index))};
}

void draw_series(const Series& series, int index, const std::vector<PixelPoint>& points, Svg& svg) {
  svg.open_group(series.name);
  if (series.style == SeriesStyle::line) {
    svg.polyline(points, line_paint(index));
  } else {
    for (const PixelPoint& point : points) {
      if (std::isfinite(point.x)) {
        draw_marker(index, point, series_ink(index), 8.0, svg);
      }
    }
  }
  svg.close_group();
}

void draw_sample(const Series& series, int index, PixelPoint left, Svg& svg) {
  const PixelPoint right = {.x = left.x + kSample, .y = left.y};
  if (series.style == SeriesStyle::line) {
    svg.line(left, right, line_paint(index));
  } else {
    draw_marker(index, {.x = left.x + kSample / 2, .y = left.y}, series_ink(index), 8.0, svg);
  }
}

// Draws the legend downwards from `top`, if there is more than one series; answers where it ends.
double draw_legend(const Chart& chart, double top, double width, Svg& svg) {
  if (chart.series.size() < 2) {
    return top;
  }
  double x = 0.0;
  double y = top;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const std::string name = fitting_text(chart.series[i].name, kTextSize, width - kSample - 8.0);
    const double size = kSample + 6.0 + text_width(name, kTextSize) + 18.0;
    if (x > 0.0 && x + size > width + 18.0) {
      x = 0.0;
      y += kLineHeight;
    }
    draw_sample(chart.series[i], static_cast<int>(i), {.x = x, .y = y + 8.0}, svg);
    svg.text({.x = x + kSample + 6.0, .y = y + 12.0}, name, {.size = kTextSize});
    x += size;
  }
  return y + kLineHeight;
}

// The rows into which labels go that stand over an axis, so that none covers another.
std::vector<int> label_rows(const std::vector<PixelBox>& boxes) {
  std::vector<int> rows;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    int row = 0;
    const auto is_taken = [&] {
      for (std::size_t j = 0; j < i; ++j) {
        if (rows[j] == row && boxes[i].left < boxes[j].right && boxes[j].left < boxes[i].right) {
          return true;
        }
      }
      return false;
    };
    while (is_taken()) {
      ++row;
    }
    rows.push_back(row);
  }
  return rows;
}

struct GuideLayout {
  std::vector<TextStyle> styles;
  std::vector<int> rows;
  int row_count = 0;
};

// Labels stand over their guides, turned inwards at the ends.
GuideLayout lay_out_guides(const Chart& chart, const Frame& frame) {
  GuideLayout layout;
  std::vector<PixelBox> boxes;
  for (const ChartGuide& guide : chart.guides) {
    TextStyle style = {.size = kTickSize, .has_halo = true};
    const double x = frame.place(guide.x, frame.y.low).x;
    const double half = text_width(guide.label, kTickSize) / 2;
    style.anchor = x - half < frame.box.left    ? Anchor::start
                   : x + half > frame.box.right ? Anchor::end
                                                : Anchor::middle;
    boxes.push_back(text_box({.x = x, .y = 0.0}, guide.label, style).grown(3.0));
    layout.styles.push_back(style);
  }
  layout.rows = label_rows(boxes);
  for (const int row : layout.rows) {
    layout.row_count = std::max(layout.row_count, row + 1);
  }
  return layout;
}

// Lines first, so that no label has one across it.
void draw_guides(const Chart& chart, const Frame& frame, const GuideLayout& layout, Svg& svg) {
  const auto place = [&](std::size_t i) {
    return PixelPoint{.x = frame.place(chart.guides[i].x, frame.y.low).x,
                      .y = frame.box.top - 6.0 - kLineHeight * layout.rows[i]};
  };
  for (std::size_t i = 0; i < chart.guides.size(); ++i) {
    const PixelPoint top = place(i);
    svg.line({.x = top.x, .y = top.y + 2.0},
             {.x = top.x, .y = frame.box.bottom},
             {.stroke = Ink::ink, .width = 1.0, .dash = "4 3"});
  }
  for (std::size_t i = 0; i < chart.guides.size(); ++i) {
    svg.text(place(i), chart.guides[i].label, layout.styles[i]);
  }
}

bool is_inside(const Frame& frame, PixelPoint point) {
  const PixelBox box = frame.box.grown(0.5);
  return point.x >= box.left && point.x <= box.right && point.y >= box.top && point.y <= box.bottom;
}

void draw_marks(const Chart& chart, const Frame& frame, PointLabels& placer, Svg& svg) {
  std::vector<PixelPoint> places;
  for (const ChartMark& mark : chart.marks) {
    const PixelPoint place = frame.place(mark.x, mark.y);
    if (is_inside(frame, place)) {
      svg.circle(place, 4.0, {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.5});
      placer.take(
          PixelBox{.left = place.x, .top = place.y, .right = place.x, .bottom = place.y}.grown(
              4.0));
    }
    places.push_back(place);
  }
  const std::size_t count = std::min<std::size_t>(places.size(), kMostLabelled);
  for (std::size_t i = 0; i < count; ++i) {
    if (is_inside(frame, places[i])) {
      placer.write(places[i], chart.marks[i].label, {.size = kTickSize, .has_halo = true}, svg);
    }
  }
}

void draw_data(const Chart& chart, const Frame& frame, Svg& svg) {
  PointLabels placer(frame.box.grown(-2.0));
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const std::vector<PixelPoint> points = visible_points(frame, chart.series[i]);
    draw_series(chart.series[i], static_cast<int>(i), points, svg);
    placer.avoid(points);
  }
  draw_marks(chart, frame, placer, svg);
}

// Draws downwards from `top`; answers where the chart ends.
double draw_chart(const Chart& chart, double top, Svg& svg) {
  double y = top;
  if (!chart.title.empty()) {
    svg.text({.x = 0.0, .y = y + 12.0}, chart.title, {.size = 13.0, .weight = Weight::bold});
    y += 22.0;
  }
  if (!has_data(chart)) {
    svg.text({.x = 0.0, .y = y + 12.0}, "no data", {.ink = Ink::soft});
    return y + kLineHeight;
  }
  y = draw_legend(chart, y, kWidth, svg) + 8.0;
  Frame frame = chart.has_equal_scales ? equal_frame(chart, y) : free_frame(chart, y);
  const GuideLayout guides = lay_out_guides(chart, frame);
  const double shift = guides.row_count * kLineHeight;
  frame.box.top += shift;
  frame.box.bottom += shift;
  draw_grid(frame, svg);
  draw_guides(chart, frame, guides, svg);
  draw_data(chart, frame, svg);
  draw_axis_titles(chart, frame, draw_tick_labels(frame, svg), svg);
  return frame.box.bottom + 40.0;
}

}  // namespace

std::string axis_title(const ChartAxis& axis, int exponent) {
  std::string unit = exponent == 0 ? axis.unit : power_of_ten(exponent) + " " + axis.unit;
  if (!unit.empty() && unit.back() == ' ') {
    unit.pop_back();
  }
  return unit.empty() ? axis.label : fmt::format("{} [{}]", axis.label, unit);
}

Picture draw_figure(const Figure& figure) {
  KINESTAT_EXPECTS(!figure.charts.empty());
  Svg svg;
  double y = 0.0;
  for (const Chart& chart : figure.charts) {
    for (const Series& series : chart.series) {
      KINESTAT_EXPECTS(series.x.size() == series.y.size());
    }
    y = draw_chart(chart, y, svg) + 14.0;
  }
  return make_picture(figure.name, figure.title, figure.description, svg);
}

}  // namespace kinestat
