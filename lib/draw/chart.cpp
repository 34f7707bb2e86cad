#include "draw/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "draw/chart_frame.hpp"
#include "draw/guide_words.hpp"
#include "draw/name_placer.hpp"
#include "draw/symbols.hpp"

namespace kinestat {

namespace {

constexpr double kLineHeight = kWordsHeight;
constexpr double kSample = 26.0;  // length of a line in the legend
constexpr double kSeen = 0.4;     // nearer points of a line are one
constexpr int kMostLabelled = 40;
constexpr double kFarthestLabel = 120.0;  // the middle of its text from the point

// Points of a line that can be told apart on the picture, with its gaps; what lies outside the
// frame is a gap too.
std::vector<PixelPoint> visible_points(const ChartFrame& frame, const Series& series) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  std::vector<PixelPoint> points;
  const auto is_gap = [](const PixelPoint& point) { return !std::isfinite(point.x); };
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const PixelPoint point = frame.place(series.x[i], series.y[i]);
    if (!frame.holds(point)) {
      if (!points.empty() && !is_gap(points.back())) {
        points.push_back({.x = kGap, .y = kGap});
      }
      continue;
    }
    const bool is_near =
        !points.empty() && !is_gap(points.back()) && length_of(point - points.back()) < kSeen;
    const bool is_last = i + 1 == series.x.size();
    if (!is_near || is_last || series.style == SeriesStyle::points) {
      points.push_back(point);
    }
  }
  return points;
}

int look_of(const Chart& chart, std::size_t series) {
  return chart.series[series].look.value_or(static_cast<int>(series));
}

Paint line_paint(int index) {
  return {.stroke = series_ink(index), .width = 2.0, .dash = std::string(series_dash(index))};
}

// A line through one point would not be seen.
bool is_alone(const std::vector<PixelPoint>& points, std::size_t i) {
  return (i == 0 || !std::isfinite(points[i - 1].x)) &&
         (i + 1 == points.size() || !std::isfinite(points[i + 1].x));
}

void draw_series(const Series& series,
                 std::size_t place,
                 int index,
                 const std::vector<PixelPoint>& points,
                 Svg& svg) {
  const std::array<Attribute, 1> mark = {{{"data-series", fmt::format("{}", place)}}};
  svg.open_group(series.name, mark);
  const bool is_line = series.style == SeriesStyle::line;
  if (is_line) {
    svg.polyline(points, line_paint(index));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i].x) && (!is_line || is_alone(points, i))) {
      draw_marker(index, points[i], series_ink(index), 8.0, svg);
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
  Svg entries;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const std::string name = fitting_text(chart.series[i].name, kChartText, width - kSample - 8.0);
    const double size = kSample + 6.0 + text_width(name, kChartText) + 18.0;
    if (x > 0.0 && x + size > width + 18.0) {
      x = 0.0;
      y += kLineHeight;
    }
    const std::array<Attribute, 1> mark = {{{"data-sample", fmt::format("{}", i)}}};
    entries.open_group({}, mark);
    draw_sample(chart.series[i], look_of(chart, i), {.x = x, .y = y + 8.0}, entries);
    entries.close_group();
    entries.text({.x = x + kSample + 6.0, .y = y + 12.0}, name, {.size = kChartText});
    x += size;
  }
  y += kLineHeight;
  const std::array<Attribute, 1> mark = {{{"data-legend", fmt::format("{}", y - top)}}};
  svg.open_group({}, mark);
  svg.add(entries);
  svg.close_group();
  return y;
}

// Those beside the axis are left out.
std::vector<ChartGuide> guides_within(const Chart& chart, const ChartFrame& frame) {
  std::vector<ChartGuide> guides;
  for (const ChartGuide& guide : chart.guides) {
    if (frame.holds({.x = frame.place(guide.x, frame.y.low).x, .y = frame.box.top})) {
      guides.push_back(guide);
    }
  }
  return guides;
}

// Series that run on each other have the same extremes, which one label tells.
bool is_said(const Chart& chart, const std::vector<PixelPoint>& places, std::size_t mark) {
  for (std::size_t i = 0; i < mark; ++i) {
    const PixelPoint between = places[i] - places[mark];
    if (mark_text(chart.marks[i], 0) == mark_text(chart.marks[mark], 0) &&
        length_of(between) < 2.0) {
      return true;
    }
  }
  return false;
}

// Within the frame; of a point without room for its label nothing is drawn.
void draw_marks(const Chart& chart, const ChartFrame& frame, NamePlacer& placer, Svg& svg) {
  const auto draw_point = [](PixelPoint place, Svg& to) {
    to.circle(place, 4.0, {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.5});
  };
  Svg points;
  points.keep_lines();
  std::vector<PixelPoint> places;
  for (const ChartMark& mark : chart.marks) {
    places.push_back(frame.place(mark.x, mark.y));
    if (frame.holds(places.back())) {
      draw_point(places.back(), points);
    }
  }
  placer.keep_off(svg.lines());
  placer.keep_off(points.lines());
  const std::size_t count = std::min<std::size_t>(places.size(), kMostLabelled);
  for (std::size_t i = 0; i < count; ++i) {
    if (!frame.holds(places[i]) || is_said(chart, places, i)) {
      continue;
    }
    constexpr TextStyle kMark = {.size = kTickText, .has_halo = true};
    const std::string text = mark_text(chart.marks[i], frame.y.exponent);
    const PlacedName label = placer.place(places[i], text, kMark, 7.0);
    // A long line would lead across the series.
    if (label.is_free && length_of(label.box.centre() - places[i]) < kFarthestLabel) {
      draw_point(places[i], svg);
      write_label(svg, label, text, kMark);
    }
  }
}

// Those across the frame: guides, and where values are zero.
void keep_off_lines(const std::vector<ChartGuide>& guides,
                    const ChartFrame& frame,
                    NamePlacer& placer) {
  const PixelBox& box = frame.box;
  for (const ChartGuide& guide : guides) {
    const double x = frame.place(guide.x, frame.y.low).x;
    placer.keep_off({.x = x, .y = box.top}, {.x = x, .y = box.bottom});
  }
  if (frame.y.kind == ScaleKind::linear && frame.y.low < 0.0 && frame.y.high > 0.0) {
    const double y = frame.place(frame.x.low, 0.0).y;
    placer.keep_off({.x = box.left, .y = y}, {.x = box.right, .y = y});
  }
}

std::string range_text(const AxisRange& range) {
  const bool is_even = range.kind == ScaleKind::linear;
  return fmt::format("{} {}{}", range.low, range.high, is_even ? "" : " log");
}

// Where the values stand, for scripts: the frame on the picture, and what its axes have.
std::array<Attribute, 3> plot_marks(const ChartFrame& frame) {
  const PixelBox& box = frame.box;
  return {{{"data-plot", fmt::format("{} {} {} {}", box.left, box.top, box.right, box.bottom)},
           {"data-x", range_text(frame.x)},
           {"data-y", range_text(frame.y)}}};
}

void draw_data(const Chart& chart,
               const std::vector<ChartGuide>& guides,
               const ChartFrame& frame,
               Svg& svg) {
  Svg data;
  if (!chart.marks.empty()) {
    data.keep_lines();
  }
  data.open_group({}, plot_marks(frame));
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const std::vector<PixelPoint> points = visible_points(frame, drawn_series(chart.series[i]));
    draw_series(chart.series[i], i, look_of(chart, i), points, data);
  }
  NamePlacer placer(frame.box.grown(-2.0));
  keep_off_lines(guides, frame, placer);
  draw_marks(chart, frame, placer, data);
  data.close_group();
  svg.add(data);
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
  y = draw_legend(chart, y, chart.width, svg) + 8.0;
  ChartFrame frame = make_frame(chart, y);
  const std::vector<ChartGuide> guides = guides_within(chart, frame);
  const GuideWords words(guides, frame);
  frame.words_above = words.row_count() * kLineHeight;
  frame.box.top += frame.words_above;
  frame.box.bottom += frame.words_above;
  draw_grid(frame, svg);
  words.draw(frame, svg);
  draw_data(chart, guides, frame, svg);
  draw_axes(chart, frame, svg);
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

std::string mark_text(const ChartMark& mark, int exponent) {
  return mark.tells_value
             ? fmt::format("{} {}", mark.label, label_number(mark.y * std::pow(10.0, -exponent)))
             : mark.label;
}

Series drawn_series(const Series& series) {
  Series drawn = {.name = series.name, .style = series.style, .look = series.look};
  const auto add = [&drawn](double x, double y) {
    drawn.x.push_back(x);
    drawn.y.push_back(y);
  };
  auto between = series.between.begin();
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (std::ranges::binary_search(series.breaks, i)) {
      constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
      add(kGap, kGap);
    }
    for (; between != series.between.end() && between->before <= i; ++between) {
      add(between->x, between->y);
    }
    add(series.x[i], series.y[i]);
  }
  return drawn;
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
