#include "draw/gnuplot.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "draw/markup.hpp"
#include "report/number_format.hpp"

namespace kinestat {

namespace {

// A script is one line a command or comment: a control character becomes a space.
std::string in_one_line(std::string text) {
  std::ranges::replace_if(text, is_ascii_control, ' ');
  return text;
}

// In single quotes nothing has a meaning but the quote itself, which is doubled.
std::string in_gnuplot_quotes(const std::string& text) {
  std::string result = "'";
  for (const char character : in_one_line(text)) {
    result += character == '\'' ? "''" : std::string(1, character);
  }
  return result + "'";
}

std::string number(double value) {
  return std::isfinite(value) ? format_exact(value) : "NaN";
}

std::string head_text(const std::string& title, const std::string& description) {
  return fmt::format("{}# {}\n# {}\nset encoding utf8\n",
                     gnuplot_signature(),
                     in_one_line(title),
                     in_one_line(description));
}

std::string block_name(std::size_t chart, std::size_t series) {
  return fmt::format("$data_{}_{}", chart + 1, series + 1);
}

std::string data_text(const Series& series, const std::string& name) {
  std::string text = name + " << END\n";
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    text += number(series.x[i]) + " " + number(series.y[i]) + "\n";
  }
  return text + "END\n";
}

// Around what is the same throughout, of which the program makes no axis without a warning.
struct AxisEnds {
  std::optional<double> low;
  std::optional<double> high;
};

AxisEnds ends_of(const Chart& chart, const ChartAxis& axis, std::vector<double> Series::*values) {
  std::optional<double> only;
  for (const Series& series : chart.series) {
    for (const double value : series.*values) {
      if (std::isfinite(value) && value != only.value_or(value)) {
        return {.low = axis.low, .high = axis.high};
      }
      only = std::isfinite(value) ? std::optional(value) : only;
    }
  }
  if (!only || axis.low || axis.high) {
    return {.low = axis.low, .high = axis.high};
  }
  const double around = *only == 0.0 ? 1.0 : 0.1 * std::abs(*only);
  return {.low = *only - around, .high = *only + around};
}

std::string axis_text(char letter, const ChartAxis& axis, const AxisEnds& ends) {
  const auto end = [](const std::optional<double>& value) {
    return value ? number(*value) : std::string("*");
  };
  return fmt::format("set {0}label {1} noenhanced\n{2} logscale {0}\nset {0}range [{3}:{4}]\n",
                     letter,
                     in_gnuplot_quotes(axis_title(axis, 0)),
                     axis.scale == ScaleKind::logarithmic ? "set" : "unset",
                     end(ends.low),
                     end(ends.high));
}

std::string guides_text(const Chart& chart) {
  std::string text;
  for (const ChartGuide& guide : chart.guides) {
    text += fmt::format(
        "set arrow from {0}, graph 0 to {0}, graph 1 nohead dashtype 2\n"
        "set label {1} noenhanced at {0}, graph 1.03\n",
        number(guide.x),
        in_gnuplot_quotes(guide.label));
  }
  for (const ChartMark& mark : chart.marks) {
    text += fmt::format("set label {} noenhanced at {}, {} point pointtype 6 offset 1, 0.5\n",
                        in_gnuplot_quotes(mark_text(mark, 0)),
                        number(mark.x),
                        number(mark.y));
  }
  return text;
}

std::string chart_text(const Chart& chart, std::size_t index) {
  std::string text = fmt::format("unset label\nunset arrow\nset title {} noenhanced\nset size {}\n",
                                 in_gnuplot_quotes(chart.title),
                                 chart.has_equal_scales ? "ratio -1" : "noratio");
  text += axis_text('x', chart.x, ends_of(chart, chart.x, &Series::x)) +
          axis_text('y', chart.y, ends_of(chart, chart.y, &Series::y)) + guides_text(chart) +
          "plot";
  for (std::size_t s = 0; s < chart.series.size(); ++s) {
    const bool is_line = chart.series[s].style == SeriesStyle::line;
    const int look = chart.series[s].look.value_or(static_cast<int>(s));
    text += fmt::format("{} \\\n  {} using 1:2 with {} title {} noenhanced",
                        s == 0 ? "" : ",",
                        block_name(index, s),
                        is_line ? fmt::format("lines dashtype {}", look % 5 + 1)
                                : fmt::format("points pointtype {}", look % 15 + 1),
                        in_gnuplot_quotes(chart.series[s].name));
  }
  return text + "\n";
}

// In as many columns as keep the picture from being much higher than wide. How large it must be
// for all charts to be read is said, not set: the terminal is the reader's.
std::string layout_text(std::size_t count) {
  constexpr std::size_t kWidth = 700;  // of a chart [px]
  constexpr std::size_t kHeight = 320;
  const std::size_t columns = count <= 3 ? 1 : count <= 8 ? 2 : 3;
  const std::size_t rows = (count + columns - 1) / columns;
  return fmt::format(
      "# To read all charts: set terminal pngcairo size {},{}\n"
      "set grid\nset key outside top center horizontal\nset multiplot layout {},{}\n",
      kWidth * columns,
      std::max<std::size_t>(kHeight * rows, 480),
      rows,
      columns);
}

// Names with what would end a string within data taken out of it.
std::string cell(const std::string& name) {
  std::string text = "\"";
  for (const char character : name) {
    const bool breaks = character == '"' || character == '\\' || is_ascii_control(character);
    text += breaks ? '_' : character;
  }
  return text + "\"";
}

std::string block_text(const BarMap& map, std::size_t index) {
  std::string text = block_name(index, 0) + " << END\n\"\"";
  for (const std::string& column : map.columns) {
    text += " " + cell(column);
  }
  text += "\n";
  for (const BarRow& row : map.blocks[index].rows) {
    text += cell(row.name);
    for (const std::optional<double>& value : row.values) {
      text += " " + (value ? number(*value) : std::string("NaN"));
    }
    text += "\n";
  }
  return text + "END\n";
}

}  // namespace

std::string_view gnuplot_signature() {
  return "# kinestat picture\n";
}

std::string gnuplot_text(const Figure& figure) {
  std::string text = head_text(figure.title, figure.description);
  for (std::size_t c = 0; c < figure.charts.size(); ++c) {
    for (std::size_t s = 0; s < figure.charts[c].series.size(); ++s) {
      text += data_text(drawn_series(figure.charts[c].series[s]), block_name(c, s));
    }
  }
  text += layout_text(figure.charts.size());
  for (std::size_t c = 0; c < figure.charts.size(); ++c) {
    text += chart_text(figure.charts[c], c);
  }
  return text + "unset multiplot\n";
}

std::string gnuplot_text(const BarMap& map) {
  std::string text = head_text(fmt::format("{}: {}", map.title, map.mechanism), map.description);
  for (std::size_t b = 0; b < map.blocks.size(); ++b) {
    text += block_text(map, b);
  }
  text += layout_text(map.blocks.size());
  text +=
      "set style data histogram\nset style histogram clustered\nset style fill pattern\n"
      "set xtics rotate by -45 noenhanced\n";
  for (std::size_t b = 0; b < map.blocks.size(); ++b) {
    text += fmt::format(
        "set title {} noenhanced\nplot for [i=2:{}] {} using i:xtic(1) title "
        "columnheader(i) noenhanced\n",
        in_gnuplot_quotes(map.blocks[b].title),
        map.columns.size() + 1,
        block_name(b, 0));
  }
  return text + "unset multiplot\n";
}

}  // namespace kinestat
