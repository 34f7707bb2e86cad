// Charts: series of points over two axes, as data that pictures and other programs' texts are made
// of.
//
// How a script reads a drawn chart. Its data stand in a group `<g data-plot="LEFT TOP RIGHT BOTTOM"
// data-x="LOW HIGH" data-y="LOW HIGH">`: the frame [px], and the values at its sides; " log"
// follows where their logarithms are even. A series is a group `data-series="I"`, counted from 0.
// The legend is a group `data-legend="HEIGHT"` [px], above everything but the title; the line or
// marker of a series in it is a group `data-sample="I"`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/axes.hpp"
#include "draw/picture.hpp"

namespace kinestat {

struct ChartAxis {
  std::string label;
  std::string unit;  ///< empty: a bare number
  ScaleKind scale = ScaleKind::linear;
  std::optional<double> low = {};   ///< the axis ends there; empty: at a tick beyond the data
  std::optional<double> high = {};  ///< likewise
  double least_step = 0.0;          ///< values stand no nearer, so that ticks need not
};

enum class SeriesStyle { line, points };

/// A point of a line that is none of the points of its series.
struct PointBetween {
  std::size_t before = 0;  ///< which of those it stands before; at least 1
  double x = 0.0;
  double y = 0.0;
};

/// A value that is not a number is a gap. No line leads to a break: a point behind a pole.
struct Series {
  std::string name;
  std::vector<double> x = {};
  std::vector<double> y = {};
  SeriesStyle style = SeriesStyle::line;
  std::optional<int> look = {};  ///< of its colour and marker; empty: its place among the series
  std::vector<std::size_t> breaks = {};    ///< indices of points, ascending
  std::vector<PointBetween> between = {};  ///< in the order of the line: peaks, and sides of jumps
};

/// A point that is worth words.
struct ChartMark {
  double x = 0.0;
  double y = 0.0;
  std::string label;
  bool tells_value = false;  ///< its y follows the label, in powers of ten of the axis
};

/// A value of x that is worth words.
struct ChartGuide {
  double x = 0.0;
  std::string label;
  bool is_named = true;  ///< by words; else only under the pointer, as words stand elsewhere
};

struct Chart {
  std::string title = {};  ///< empty: none
  ChartAxis x;
  ChartAxis y;
  std::vector<Series> series;
  std::vector<ChartMark> marks = {};
  std::vector<ChartGuide> guides = {};
  bool has_equal_scales = false;  ///< a unit of x is as long as one of y
  double width = 720.0;           ///< of its frame, if scales are not equal [px]
};

/// Charts below each other.
struct Figure {
  std::string name;
  std::string title;
  std::string description;
  std::vector<Chart> charts;
};

/// As it is drawn: with the points between others, and its breaks as gaps.
Series drawn_series(const Series& series);

/// "max 4.5", of an axis in units of 10^exponent.
std::string mark_text(const ChartMark& mark, int exponent);

/// The figure; without any finite value a chart says "no data".
Picture draw_figure(const Figure& figure);

/// "speed [rad/s]", "speed [10³ rad/s]", "speed" of a bare number.
std::string axis_title(const ChartAxis& axis, int exponent);

}  // namespace kinestat
