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
constexpr double kValueWidth = 68.0;  // of the number beside it
constexpr double kMostNameWidth = 190.0;
constexpr double kValueSize = 11.0;

constexpr double kNameGap = 12.0;

// How the cells of a case are laid out.
struct CellForm {
  double bar = 88.0;      // of the whole scale
  double gap = 26.0;      // to the next case
  std::size_t aside = 5;  // more stand below

  double width() const { return bar + kValueWidth + gap; }
};

// Of a part.
constexpr CellForm kClose = {.bar = 56.0, .gap = 14.0};

// From the value at the left end of the bars to that at the right.
struct Scale {
  double low = 0.0;
  double high = 0.0;

  double share(double value) const { return high > low ? (value - low) / (high - low) : 0.0; }
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

bool is_zero(const BarRow& row) {
  return std::ranges::all_of(row.values, [](const auto& value) { return value == 0.0; });
}

// From so many rows of zeros on, their names in a line say it.
constexpr std::ptrdiff_t kManyZeros = 4;

bool sums_up_zeros(const BarBlock& block) {
  return std::ranges::count_if(block.rows, is_zero) >= kManyZeros;
}

// The rows that are shown, in their order.
std::vector<std::size_t> shown_rows(const BarBlock& block) {
  std::vector<std::size_t> rows;
  const bool are_zeros_shown = !sums_up_zeros(block);
  for (std::size_t i = 0; i < block.rows.size(); ++i) {
    if (are_zeros_shown || !is_zero(block.rows[i])) {
      rows.push_back(i);
    }
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

// The room that names take.
double name_width(const BarMap& map) {
  double width = 40.0;
  for (const BarBlock& block : map.blocks) {
    for (const BarRow& row : block.rows) {
      width = std::max(width, text_width(row.name, kTextSize));
    }
  }
  return std::min(width, kMostNameWidth);
}

// Of some of the cases: a range of columns.
struct Columns {
  std::size_t first = 0;
  std::size_t end = 0;
};

class BarMapDrawing {
 public:
  BarMapDrawing(const BarMap& map, Columns columns, CellForm form)
      : map_(map), columns_(columns), form_(form), name_width_(name_width(map)) {}

  Picture run(const std::string& title) {
    for (const BarBlock& block : map_.blocks) {
      draw(block);
    }
    for (const std::string& remark : map_.remarks) {
      y_ += kRowHeight;
      svg_.text({.x = 0.0, .y = y_}, remark, {.ink = Ink::soft, .size = kTextSize});
    }
    return make_picture(
        map_.name, fmt::format("{}: {}", title, map_.mechanism), map_.description, svg_);
  }

 private:
  void draw(const BarBlock& block) {
    svg_.text({.x = 0.0, .y = y_ + 12.0}, block.title, {.size = 13.0, .weight = Weight::bold});
    y_ += 22.0;
    const std::vector<std::size_t> rows = shown_rows(block);
    const Scale scale = scale_of(block);
    for (std::size_t first = columns_.first; first < columns_.end; first += form_.aside) {
      const std::size_t end = std::min(first + form_.aside, columns_.end);
      draw_heads(first, end);
      draw_rows({.block = block, .rows = rows, .scale = scale, .first = first, .end = end});
      y_ += 12.0;
    }
    if (rows.size() == kMostBarRows && rows.size() < block.rows.size()) {
      write_remark(fmt::format("and {} with smaller values", block.rows.size() - rows.size()));
    } else if (rows.size() < block.rows.size()) {
      write_zeros(block);
    }
    y_ += 10.0;
  }

  void write_remark(const std::string& remark) {
    svg_.text({.x = 0.0, .y = y_}, remark, {.ink = Ink::soft, .size = kTextSize});
    y_ += kRowHeight;
  }

  // "0 in s1, r1, K3", in as many lines as need be.
  void write_zeros(const BarBlock& block) {
    const double width =
        cell_left(std::min(columns_.end - columns_.first, form_.aside)) - form_.gap;
    std::string line = "0 in";
    for (const BarRow& row : block.rows) {
      if (!is_zero(row)) {
        continue;
      }
      const std::string longer = line + (line == "0 in" ? " " : ", ") + row.name;
      if (text_width(longer, kTextSize) > width && line != "0 in") {
        write_remark(line + ",");
        line = row.name;
      } else {
        line = longer;
      }
    }
    write_remark(line);
  }

  double cell_left(std::size_t column) const {
    return name_width_ + kNameGap + form_.width() * static_cast<double>(column);
  }

  void draw_heads(std::size_t first, std::size_t end) {
    for (std::size_t c = first; c < end; ++c) {
      const std::string& column = map_.columns[c];
      const std::string shown = fitting_text(column, kTextSize, form_.width() - 8.0, Weight::bold);
      const bool is_cut = shown != column;
      if (is_cut) {
        svg_.open_group(column);
      }
      svg_.text({.x = cell_left(c - first), .y = y_ + 12.0},
                shown,
                {.size = kTextSize, .weight = Weight::bold});
      if (is_cut) {
        svg_.close_group();
      }
    }
    y_ += kRowHeight;
  }

  // Rows below each other, with some of the columns.
  struct Part {
    const BarBlock& block;
    const std::vector<std::size_t>& rows;
    const Scale& scale;
    std::size_t first = 0;
    std::size_t end = 0;
  };

  // What is alike one after the other: so the picture is short.
  void draw_rows(const Part& part) {
    const double top = y_;
    for (std::size_t r = 0; r < part.rows.size(); ++r) {
      const double y = top + kRowHeight * static_cast<double>(r + 1);
      svg_.line({.x = 0.0, .y = y},
                {.x = cell_left(part.end - part.first) - form_.gap, .y = y},
                {.stroke = Ink::grid, .width = 1.0});
    }
    draw_bars(part);
    for (std::size_t r = 0; r < part.rows.size(); ++r) {
      draw_name(part.block.rows[part.rows[r]].name, top + kRowHeight * static_cast<double>(r));
    }
    draw_values(part, false);
    draw_values(part, true);
    y_ = top + kRowHeight * static_cast<double>(part.rows.size());
    draw_zero_lines(part.scale, top, part.end - part.first);
  }

  // Column by column, what is zero or not known softly.
  void draw_values(const Part& part, bool is_soft) {
    for (std::size_t c = part.first; c < part.end; ++c) {
      std::vector<std::pair<double, std::string>> texts;
      for (std::size_t r = 0; r < part.rows.size(); ++r) {
        const std::optional<double>& value = part.block.rows[part.rows[r]].values[c];
        if ((value.value_or(0.0) == 0.0) == is_soft) {
          texts.emplace_back(y_ + kRowHeight * static_cast<double>(r) + 13.0,
                             value ? label_number(*value) : "–");
        }
      }
      svg_.column(
          cell_left(c - part.first) + form_.bar + kValueWidth,
          texts,
          {.ink = is_soft ? Ink::soft : Ink::ink, .size = kValueSize, .anchor = Anchor::end});
    }
  }

  // With the value, the left end and the top of each.
  template <class Draw>
  void each_cell(const Part& part, const Draw& draw) const {
    for (std::size_t r = 0; r < part.rows.size(); ++r) {
      for (std::size_t c = part.first; c < part.end; ++c) {
        draw(part.block.rows[part.rows[r]].values[c],
             cell_left(c - part.first),
             y_ + kRowHeight * static_cast<double>(r));
      }
    }
  }

  // A name that is cut is whole where it is pointed at.
  void draw_name(const std::string& name, double y) {
    const std::string shown = fitting_text(name, kTextSize, name_width_);
    const TextStyle style = {.size = kTextSize, .anchor = Anchor::end};
    const PixelPoint place = {.x = name_width_, .y = y + 13.0};
    if (shown == name) {
      svg_.text(place, shown, style);
      return;
    }
    svg_.open_group(name);
    svg_.text(place, shown, style);
    svg_.close_group();
  }

  // Negative bars are hatched, so that the sign shows without colour.
  void draw_bars(const Part& part) {
    const auto each_bar = [&](double sign, const auto& draw) {
      each_cell(part, [&](const std::optional<double>& value, double left, double y) {
        if (value && sign * *value > 0.0) {
          draw(bar_of(*value, left, y, part.scale));
        }
      });
    };
    each_bar(1.0, [this](const PixelBox& bar) {
      svg_.rectangle(bar, {.stroke = Ink::none, .fill = Ink::blue});
    });
    each_bar(-1.0, [this](const PixelBox& bar) {
      svg_.rectangle(bar, {.stroke = Ink::vermilion, .fill = Ink::paper, .width = 1.0});
    });
    each_bar(-1.0, [this](const PixelBox& bar) { svg_.hatch(bar, Ink::vermilion, 4.0); });
  }

  PixelBox bar_of(double value, double left, double y, const Scale& scale) const {
    const double zero = left + form_.bar * scale.share(0.0);
    const double end = left + form_.bar * scale.share(value);
    const double top = y + (kRowHeight - kBarHeight) / 2;
    return {.left = std::min(zero, end),
            .top = top,
            .right = std::max(zero, end),
            .bottom = top + kBarHeight};
  }

  void draw_zero_lines(const Scale& scale, double top, std::size_t count) {
    for (std::size_t c = 0; c < count; ++c) {
      const double x = cell_left(c) + form_.bar * scale.share(0.0);
      svg_.line({.x = x, .y = top}, {.x = x, .y = y_}, {.stroke = Ink::soft, .width = 1.0});
    }
  }

  const BarMap& map_;
  Columns columns_;
  CellForm form_;
  Svg svg_;
  double name_width_ = 0.0;
  double y_ = 0.0;
};

void expect_whole(const BarMap& map) {
  KINESTAT_EXPECTS(!map.blocks.empty() || !map.remarks.empty());
  for (const BarBlock& block : map.blocks) {
    for (const BarRow& row : block.rows) {
      KINESTAT_EXPECTS(row.values.size() == map.columns.size());
    }
  }
}

// Of one case, which would be long and narrow: so many blocks as have few rows together.
std::vector<Picture> draw_blocks_in_parts(const BarMap& map) {
  constexpr std::size_t kMostRows = 30;
  std::vector<BarMap> parts;
  std::size_t rows = kMostRows;
  for (const BarBlock& block : map.blocks) {
    rows += shown_rows(block).size();
    if (parts.empty() || rows > kMostRows) {
      parts.push_back(map);
      parts.back().blocks.clear();
      parts.back().remarks.clear();
      rows = shown_rows(block).size();
    }
    parts.back().blocks.push_back(block);
  }
  if (parts.size() <= 1) {
    return {draw_bar_map(map)};
  }
  parts.back().remarks = map.remarks;
  std::vector<Picture> pictures;
  for (BarMap& part : parts) {
    std::vector<std::string> titles;
    for (const BarBlock& block : part.blocks) {
      titles.push_back(block.title.substr(0, block.title.find(" [")));
    }
    part.title = fmt::format("{}, {}", map.title, fmt::join(titles, ", "));
    pictures.push_back(draw_bar_map(part));
  }
  return pictures;
}

}  // namespace

Picture draw_bar_map(const BarMap& map) {
  expect_whole(map);
  return BarMapDrawing(map, {.first = 0, .end = map.columns.size()}, {}).run(map.title);
}

std::vector<Picture> draw_bar_map_in_parts(const BarMap& map) {
  expect_whole(map);
  const double room = kTelephone - name_width(map) - kNameGap + kClose.gap;
  const auto aside = static_cast<std::size_t>(std::max(room / kClose.width(), 1.0));
  const std::size_t count = map.columns.size();
  if (count <= 1) {
    return draw_blocks_in_parts(map);
  }
  std::vector<Picture> parts;
  for (std::size_t first = 0; first < count; first += aside) {
    const Columns columns = {.first = first, .end = std::min(first + aside, count)};
    const std::vector<std::string> cases(
        map.columns.begin() + static_cast<std::ptrdiff_t>(columns.first),
        map.columns.begin() + static_cast<std::ptrdiff_t>(columns.end));
    const std::string title = fmt::format("{}, {}", map.title, fmt::join(cases, ", "));
    parts.push_back(BarMapDrawing(map, columns, kClose).run(aside < count ? title : map.title));
  }
  return parts;
}

}  // namespace kinestat
