#include "draw/bar_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "draw/axes.hpp"
#include "draw/text_styles.hpp"

namespace kinestat {

namespace {

constexpr double kRowHeight = 19.0;
constexpr double kBarHeight = 11.0;
constexpr double kBarWidth = 88.0;    // of the whole scale in a cell
constexpr double kValueWidth = 68.0;  // of the number beside it
constexpr double kCellGap = 26.0;
constexpr double kCellWidth = kBarWidth + kValueWidth + kCellGap;
constexpr double kMostNameWidth = 190.0;
constexpr double kValueSize = 11.0;
constexpr std::size_t kColumnsAside = 5;  // more stand below

constexpr double kNameGap = 12.0;

// From the value at the left end of the bars to that at the right.
struct Scale {
  double low = 0.0;
  double high = 0.0;

  double place(double value) const {
    return high > low ? (value - low) / (high - low) * kBarWidth : 0.0;
  }
};

Scale scale_of(const BarBlock& block) {
  Scale scale;
  for (const BarRow& row : block.rows) {
    for (const std::optional<double>& value : row.values) {
      scale.low = std::min(scale.low, value.value_or(0.0));
      scale.high = std::max(scale.high, value.value_or(0.0));
    }
  }
  return scale;
}

double largest(const BarRow& row) {
  double size = 0.0;
  for (const std::optional<double>& value : row.values) {
    size = std::max(size, std::abs(value.value_or(0.0)));
  }
  return size;
}

// The rows that are shown, in their order.
std::vector<std::size_t> shown_rows(const BarBlock& block) {
  std::vector<std::size_t> rows(block.rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i] = i;
  }
  if (rows.size() > kMostBarRows) {
    std::ranges::stable_sort(rows, [&block](std::size_t a, std::size_t b) {
      return largest(block.rows[a]) > largest(block.rows[b]);
    });
    rows.resize(kMostBarRows);
    std::ranges::sort(rows);
  }
  return rows;
}

class BarMapDrawing {
 public:
  explicit BarMapDrawing(const BarMap& map) : map_(map) {
    for (const BarBlock& block : map.blocks) {
      for (const BarRow& row : block.rows) {
        name_width_ = std::max(name_width_, text_width(row.name, kTextSize));
      }
    }
    name_width_ = std::min(name_width_, kMostNameWidth);
  }

  Picture run() {
    for (const BarBlock& block : map_.blocks) {
      draw(block);
    }
    for (const std::string& remark : map_.remarks) {
      y_ += kRowHeight;
      svg_.text({.x = 0.0, .y = y_}, remark, {.ink = Ink::soft, .size = kTextSize});
    }
    return make_picture(map_.name, map_.title, map_.description, svg_);
  }

 private:
  void draw(const BarBlock& block) {
    svg_.text({.x = 0.0, .y = y_ + 12.0}, block.title, {.size = 13.0, .weight = Weight::bold});
    y_ += 22.0;
    const std::vector<std::size_t> rows = shown_rows(block);
    const Scale scale = scale_of(block);
    for (std::size_t first = 0; first < map_.columns.size(); first += kColumnsAside) {
      const std::size_t end = std::min(first + kColumnsAside, map_.columns.size());
      draw_heads(first, end);
      const double top = y_;
      for (const std::size_t row : rows) {
        draw_row(block.rows[row], scale, first, end);
      }
      draw_zero_lines(scale, top, end - first);
      y_ += 12.0;
    }
    if (rows.size() < block.rows.size()) {
      svg_.text({.x = 0.0, .y = y_},
                fmt::format("and {} with smaller values", block.rows.size() - rows.size()),
                {.ink = Ink::soft, .size = kTextSize});
      y_ += kRowHeight;
    }
    y_ += 10.0;
  }

  double cell_left(std::size_t column) const {
    return name_width_ + kNameGap + kCellWidth * static_cast<double>(column);
  }

  void draw_heads(std::size_t first, std::size_t end) {
    for (std::size_t c = first; c < end; ++c) {
      svg_.text({.x = cell_left(c - first), .y = y_ + 12.0},
                fitting_text(map_.columns[c], kTextSize, kCellWidth - 8.0, Weight::bold),
                {.size = kTextSize, .weight = Weight::bold});
    }
    y_ += kRowHeight;
  }

  void draw_row(const BarRow& row, const Scale& scale, std::size_t first, std::size_t end) {
    svg_.text({.x = name_width_, .y = y_ + 13.0},
              fitting_text(row.name, kTextSize, name_width_),
              {.size = kTextSize, .anchor = Anchor::end});
    for (std::size_t c = first; c < end; ++c) {
      draw_cell(row, c, cell_left(c - first), scale);
    }
    y_ += kRowHeight;
    svg_.line({.x = 0.0, .y = y_},
              {.x = cell_left(end - first) - kCellGap, .y = y_},
              {.stroke = Ink::grid, .width = 1.0});
  }

  void draw_cell(const BarRow& row, std::size_t column, double left, const Scale& scale) {
    const std::optional<double>& value = row.values[column];
    const std::string text = value ? label_number(*value) : "–";
    svg_.open_group(fmt::format("{}, {}: {}", row.name, map_.columns[column], text));
    if (value && *value != 0.0) {
      draw_bar(*value, left, scale);
    }
    svg_.text({.x = left + kBarWidth + kValueWidth, .y = y_ + 13.0},
              text,
              {.ink = value.value_or(0.0) == 0.0 ? Ink::soft : Ink::ink,
               .size = kValueSize,
               .anchor = Anchor::end});
    svg_.close_group();
  }

  // Negative bars are hatched, so that the sign shows without colour.
  void draw_bar(double value, double left, const Scale& scale) {
    const double zero = left + scale.place(0.0);
    const double end = left + scale.place(value);
    const double top = y_ + (kRowHeight - kBarHeight) / 2;
    PixelBox box = {.left = std::min(zero, end),
                    .top = top,
                    .right = std::max(zero, end),
                    .bottom = top + kBarHeight};
    if (value > 0.0) {
      svg_.rectangle(box, {.stroke = Ink::none, .fill = Ink::blue});
      return;
    }
    svg_.rectangle(box, {.stroke = Ink::vermilion, .fill = Ink::paper, .width = 1.0});
    svg_.hatch(box, Ink::vermilion, 4.0);
  }

  void draw_zero_lines(const Scale& scale, double top, std::size_t count) {
    for (std::size_t c = 0; c < count; ++c) {
      const double x = cell_left(c) + scale.place(0.0);
      svg_.line({.x = x, .y = top}, {.x = x, .y = y_}, {.stroke = Ink::soft, .width = 1.0});
    }
  }

  const BarMap& map_;
  Svg svg_;
  double name_width_ = 40.0;
  double y_ = 0.0;
};

}  // namespace

Picture draw_bar_map(const BarMap& map) {
  KINESTAT_EXPECTS(!map.blocks.empty() || !map.remarks.empty());
  for (const BarBlock& block : map.blocks) {
    for (const BarRow& row : block.rows) {
      KINESTAT_EXPECTS(row.values.size() == map.columns.size());
    }
  }
  return BarMapDrawing(map).run();
}

}  // namespace kinestat
