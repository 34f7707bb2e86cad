#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "draw/axes.hpp"
#include "draw/picture_title.hpp"
#include "draw/text_styles.hpp"
#include "studies/shift/picture/ratio_ladder.hpp"
#include "studies/shift/report/gear_report.hpp"

namespace kinestat {

namespace {

constexpr double kStateHeight = 26.0;
constexpr double kPadding = 14.0;
constexpr double kMostStateWidth = 180.0;
constexpr double kDot = 7.0;

// States that are no gear: more of them nobody reads here.
constexpr std::size_t kMostOthers = 16;

// A column of text right of the elements.
struct TextCells {
  std::string head;
  std::vector<std::string> cells;  // one a row
};

class MatrixDrawing {
 public:
  explicit MatrixDrawing(const Analysis& analysis)
      : analysis_(analysis),
        plan_(analysis.shift->plan),
        solution_(analysis.shift->solution),
        gear_count_(solution_.table.steps.size()),
        row_count_(std::min(solution_.states.size(), gear_count_ + kMostOthers)) {
    make_columns();
    for (std::size_t s = 0; s < row_count_; ++s) {
      name_width_ =
          std::max(name_width_, text_width(solution_.states[s].name, kTextSize, Weight::bold));
    }
    name_width_ = std::min(name_width_, kMostStateWidth);
  }

  Picture run() {
    draw_heads();
    for (std::size_t s = 0; s < row_count_; ++s) {
      draw_row(s);
    }
    draw_legend();
    return make_picture("shift-matrix",
                        picture_title("Shift matrix", analysis_),
                        "Which clutches and brakes each gear engages, with its ratio.",
                        svg_);
  }

 private:
  const std::string& element_name(std::size_t element) const {
    const auto actuator = static_cast<std::size_t>(plan_.elements[element].actuator);
    return analysis_.mechanism.topology.actuators[actuator].name;
  }

  void make_columns() {
    const std::string unit = gear_ratio_units(analysis_).front().ratio.unit;
    TextCells ratio = {.head = unit.empty() ? "ratio" : fmt::format("ratio [{}]", unit),
                       .cells = {}};
    TextCells step = {.head = "step", .cells = {}};
    TextCells efficiency = {.head = "efficiency", .cells = {}};
    bool is_lossy = false;
    for (std::size_t s = 0; s < row_count_; ++s) {
      if (s >= gear_count_) {
        ratio.cells.emplace_back(word_of(solution_.states[s].state.kind));
        step.cells.emplace_back();
        efficiency.cells.emplace_back();
        continue;
      }
      const GearValues values = gear_values(analysis_, s);
      const CaseAnalysis& one = *find_gear_case(analysis_, solution_.states[s]);
      std::string ratios;
      for (const RatiosInUnits& to_output : gear_ratios(analysis_, s, values)) {
        const std::optional<double>& value = to_output.ratio.value;
        ratios += (ratios.empty() ? "" : " / ") + (value ? label_number(*value) : std::string("–"));
      }
      ratio.cells.push_back(std::move(ratios));
      const std::optional<double>& jump = solution_.table.steps[s];
      step.cells.push_back(jump ? label_number(*jump) : "");
      const std::optional<double> share =
          one.efficiency ? one.efficiency->carrier.value : std::nullopt;
      efficiency.cells.push_back(share ? label_number(*share) : "");
      is_lossy = is_lossy || share.has_value();
    }
    texts_ = {std::move(ratio), std::move(step)};
    if (is_lossy) {
      texts_.push_back(std::move(efficiency));
    }
  }

  double element_width(std::size_t element) const {
    return std::max(2 * kDot + 6.0, text_width(element_name(element), kTextSize, Weight::bold)) +
           kPadding;
  }

  static double width_of(const TextCells& column) {
    double width = text_width(column.head, kTextSize, Weight::bold);
    for (const std::string& cell : column.cells) {
      width = std::max(width, text_width(cell, kTextSize));
    }
    return width + kPadding;
  }

  void draw_heads() {
    const TextStyle style = {.size = kTextSize, .weight = Weight::bold, .anchor = Anchor::middle};
    double x = name_width_ + kPadding;
    for (std::size_t e = 0; e < plan_.elements.size(); ++e) {
      svg_.text({.x = x + element_width(e) / 2, .y = 12.0}, element_name(e), style);
      x += element_width(e);
    }
    for (const TextCells& column : texts_) {
      x += width_of(column);
      svg_.text({.x = x, .y = 12.0},
                column.head,
                {.size = kTextSize, .weight = Weight::bold, .anchor = Anchor::end});
    }
    right_ = x;
    y_ = 20.0;
    draw_rule(Ink::soft);
  }

  void draw_rule(Ink ink) {
    svg_.line({.x = 0.0, .y = y_}, {.x = right_, .y = y_}, {.stroke = ink, .width = 1.0});
  }

  void draw_row(std::size_t s) {
    const NamedShiftState& state = solution_.states[s];
    const bool is_gear = s < gear_count_;
    const Ink ink = is_gear ? Ink::ink : Ink::soft;
    const double base = y_ + kStateHeight / 2 + 4.0;
    if (s == gear_count_ && s > 0) {
      draw_rule(Ink::soft);
    }
    svg_.open_group(fmt::format("{}: {}", state.name, is_gear ? texts_[0].cells[s] : state.reason));
    svg_.text({.x = 0.0, .y = base},
              fitting_text(state.name, kTextSize, name_width_, Weight::bold),
              {.ink = ink, .size = kTextSize, .weight = is_gear ? Weight::bold : Weight::normal});
    double x = draw_dots(state, ink);
    for (const TextCells& column : texts_) {
      x += width_of(column);
      svg_.text({.x = x, .y = base},
                column.cells[s],
                {.ink = ink, .size = kTextSize, .anchor = Anchor::end});
    }
    svg_.close_group();
    y_ += kStateHeight;
    draw_rule(Ink::grid);
  }

  // Answers where the elements end.
  double draw_dots(const NamedShiftState& state, Ink ink) {
    double x = name_width_ + kPadding;
    for (std::size_t e = 0; e < plan_.elements.size(); ++e) {
      const PixelPoint centre = {.x = x + element_width(e) / 2, .y = y_ + kStateHeight / 2};
      if (std::ranges::binary_search(state.engaged, static_cast<int>(e))) {
        const Ink fill = ink == Ink::ink ? Ink::blue : Ink::soft;
        svg_.circle(centre, kDot, {.stroke = fill, .fill = fill});
      } else {
        svg_.circle(centre, 1.5, {.stroke = Ink::none, .fill = Ink::soft});
      }
      x += element_width(e);
    }
    return x;
  }

  void draw_legend() {
    y_ += 20.0;
    svg_.circle({.x = kDot, .y = y_ - 4.0}, kDot - 1.5, {.stroke = Ink::blue, .fill = Ink::blue});
    std::string words = "engaged";
    if (solution_.table.span) {
      words += fmt::format("; ratio spread of the forward gears {}",
                           label_number(*solution_.table.span));
    }
    if (row_count_ < solution_.states.size()) {
      words += fmt::format("; {} more that are not gears", solution_.states.size() - row_count_);
    }
    svg_.text({.x = 2 * kDot + 6.0, .y = y_}, words, {.ink = Ink::soft, .size = kTextSize});
  }

  const Analysis& analysis_;
  const ShiftPlan& plan_;
  const ShiftSolution& solution_;
  std::size_t gear_count_ = 0;
  std::size_t row_count_ = 0;
  std::vector<TextCells> texts_;
  double name_width_ = 30.0;
  double right_ = 0.0;
  double y_ = 0.0;
  Svg svg_;
};

}  // namespace

Picture draw_shift_matrix(const Analysis& analysis) {
  KINESTAT_EXPECTS(analysis.shift.has_value());
  return MatrixDrawing(analysis).run();
}

}  // namespace kinestat
