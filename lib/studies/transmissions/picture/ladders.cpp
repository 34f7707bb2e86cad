#include "studies/transmissions/picture/ladders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "draw/axes.hpp"
#include "draw/picture_title.hpp"
#include "draw/text_styles.hpp"

namespace kinestat {

namespace {

constexpr double kLeft = 34.0;  // of the number of a ladder
constexpr double kFirstColumn = 58.0;
constexpr double kColumn = 72.0;
constexpr double kMark = 4.0;
constexpr double kLabelDistance = 34.0;  // of labels as 0.765
constexpr double kBelow = 36.0;          // from the line of a ladder to words below it

struct Column {
  const char* title;
  double (*value)(const LadderGroup&);
};

const LadderFigures& figures_of(const LadderGroup& group) {
  return group.variants.front().found.figures;
}

constexpr std::array kColumns = {
    Column{"efficiency",
           [](const LadderGroup& group) { return figures_of(group).mean_efficiency; }},
    Column{"torque", [](const LadderGroup& group) { return figures_of(group).element_torque; }},
    Column{"speed", [](const LadderGroup& group) { return figures_of(group).shaft_speed; }},
    Column{"number",
           [](const LadderGroup& group) { return static_cast<double>(group.variants.size()); }}};

class LaddersDrawing {
 public:
  LaddersDrawing(const std::vector<LadderGroup>& groups, LadderForm form)
      : groups_(groups), is_narrow_(form == LadderForm::narrow) {
    low_ = 1.0;
    high_ = 1.0;
    for (const LadderGroup& group : groups) {
      for (const LadderGear& gear : group.variants.front().gears) {
        low_ = std::min(low_, std::abs(gear.figures.ratio));
        high_ = std::max(high_, std::abs(gear.figures.ratio));
      }
    }
    low_ /= 1.05;
    high_ *= 1.05;
  }

  Svg run() {
    draw_axis();
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      draw_row(i);
    }
    return std::move(svg_);
  }

 private:
  double place(double ratio) const {
    return axis_ * std::log(high_ / std::abs(ratio)) / std::log(high_ / low_);
  }

  double height(std::size_t row) const { return row_ * static_cast<double>(row); }

  double column(std::size_t which) const {
    return axis_ + kFirstColumn + kColumn * static_cast<double>(which);
  }

  void draw_axis() {
    const double top = -22.0;
    const double bottom = height(groups_.size()) - row_ + 20.0;
    for (const double tick : ratio_ticks(low_, high_)) {
      svg_.line({.x = place(tick), .y = top},
                {.x = place(tick), .y = bottom},
                {.stroke = Ink::grid, .width = 1.0});
      TextStyle style = kSmall;
      style.anchor = Anchor::middle;
      svg_.text({.x = place(tick), .y = top - 6.0}, label_number(tick), style);
    }
    TextStyle style = {.size = kTextSize, .anchor = Anchor::middle};
    svg_.text({.x = axis_ / 2, .y = top - 24.0}, "magnitude of the ratio", style);
    style = kSmall;
    style.anchor = Anchor::middle;
    for (std::size_t i = 0; !is_narrow_ && i < kColumns.size(); ++i) {
      svg_.text({.x = column(i), .y = top - 6.0}, kColumns[i].title, style);
    }
  }

  void draw_row(std::size_t row) {
    const LadderGroup& group = groups_[row];
    const std::vector<LadderGear>& gears = group.variants.front().gears;
    const double y = height(row);
    svg_.open_group(fmt::format("Ladder {}", row));
    svg_.text({.x = -kLeft, .y = y + 4.0},
              fmt::format("{}", row),
              {.size = kTextSize, .weight = Weight::bold, .anchor = Anchor::middle});
    std::vector<PixelPoint> forward;
    for (const LadderGear& gear : gears) {
      if (gear.figures.ratio > 0.0) {
        forward.push_back({.x = place(gear.figures.ratio), .y = y});
      }
    }
    svg_.polyline(forward, {.stroke = Ink::blue, .width = 2.0});
    for (const LadderGear& gear : gears) {
      const PixelPoint at = {.x = place(gear.figures.ratio), .y = y};
      gear.figures.ratio > 0.0
          ? svg_.circle(at, kMark, {.stroke = Ink::blue, .fill = Ink::blue})
          : svg_.circle(at, kMark + 2.0, {.stroke = Ink::vermilion, .width = 2.0});
    }
    write_ratios(gears, y);
    is_narrow_ ? write_below(group, y) : write_beside(group, y);
    svg_.close_group();
  }

  void write_beside(const LadderGroup& group, double y) {
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      svg_.text({.x = column(i), .y = y + 4.0},
                label_number(kColumns[i].value(group)),
                {.size = kTextSize, .anchor = Anchor::middle});
    }
  }

  void write_below(const LadderGroup& group, double y) {
    std::vector<std::string> words;
    for (const Column& one : kColumns) {
      words.push_back(fmt::format("{} {}", one.title, label_number(one.value(group))));
    }
    svg_.text({.x = 0.0, .y = y + kBelow}, fmt::format("{}", fmt::join(words, ", ")), kSmall);
  }

  // Forward ones above the line, moved apart where they stand close; reverse ones below.
  void write_ratios(const std::vector<LadderGear>& gears, double y) {
    TextStyle style = kSmall;
    style.anchor = Anchor::middle;
    style.has_halo = true;
    std::vector<double> wished;
    for (const LadderGear& gear : gears) {
      if (gear.figures.ratio > 0.0) {
        wished.push_back(place(gear.figures.ratio));
      }
    }
    const std::vector<double> places = spread_places(wished, kLabelDistance);
    std::size_t next = 0;
    for (const LadderGear& gear : gears) {
      const bool is_forward = gear.figures.ratio > 0.0;
      svg_.text({.x = is_forward ? places[next++] : place(gear.figures.ratio),
                 .y = is_forward ? y - 9.0 : y + 18.0},
                label_number(gear.figures.ratio, 3),
                style);
    }
  }

  const std::vector<LadderGroup>& groups_;
  bool is_narrow_;
  double axis_ = is_narrow_ ? 350.0 : 460.0;  // from the largest ratio to the smallest [px]
  double row_ = is_narrow_ ? 66.0 : 40.0;
  double low_ = 1.0;
  double high_ = 1.0;
  Svg svg_;
};

// Those that no other beats in both: efficiency, and a figure of which less is better.
std::vector<bool> find_front(const std::vector<LadderFigures>& all, double LadderFigures::*figure) {
  std::vector<std::size_t> order(all.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  std::ranges::sort(
      order, {}, [&](std::size_t i) { return std::pair(-all[i].mean_efficiency, all[i].*figure); });
  std::vector<bool> is_on_front(all.size());
  const LadderFigures* last = nullptr;
  for (const std::size_t i : order) {
    if (last == nullptr || all[i].*figure < last->*figure) {
      is_on_front[i] = true;
      last = &all[i];
    }
  }
  return is_on_front;
}

// Of an axis of efficiencies: a tenth of what is lacking below the least.
double lower_end(double least) {
  constexpr double kOfLossless = 0.9;
  return least < 1.0 ? least - 0.1 * (1.0 - least) : kOfLossless;
}

Chart trade_off(const std::vector<LadderFigures>& all,
                const char* title,
                const char* label,
                double LadderFigures::*figure) {
  Chart chart = {.title = title,
                 .x = {.label = "mean efficiency of the forward gears", .unit = ""},
                 .y = {.label = label, .unit = ""},
                 .series = {{.name = "transmissions", .style = SeriesStyle::points},
                            {.name = "no other is better in both"}}};
  const std::vector<bool> is_on_front = find_front(all, figure);
  std::vector<std::pair<double, double>> front;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_on_front[i]) {
      front.emplace_back(all[i].mean_efficiency, all[i].*figure);
    }
    chart.series[0].x.push_back(all[i].mean_efficiency);
    chart.series[0].y.push_back(all[i].*figure);
  }
  std::ranges::sort(front);
  for (const auto& [efficiency, value] : front) {
    chart.series[1].x.push_back(efficiency);
    chart.series[1].y.push_back(value);
  }
  if (front.size() < 2) {
    chart.series.pop_back();  // no line
  }
  const auto least = std::ranges::min_element(chart.series[0].x);
  if (least != chart.series[0].x.end()) {
    chart.x.low = lower_end(*least);
    chart.x.high = 1.0;  // no efficiency is above
  }
  return chart;
}

}  // namespace

Picture draw_ladders(const TransmissionAnalysis& analysis, LadderForm form) {
  KINESTAT_EXPECTS(!analysis.groups.empty());
  const std::size_t count = analysis.groups.size();
  const Svg svg = LaddersDrawing(analysis.groups, form).run();
  return make_picture(
      "ladders",
      picture_title("Ladders", analysis.file, analysis.description),
      fmt::format("The best {} of {} ladders: magnitudes of the ratios from first gear to last on "
                  "a logarithmic axis, the reverse gear as a ring; of the best transmission of "
                  "each the mean efficiency, the largest torque of an element and speed of a shaft "
                  "by those of the input, and how many transmissions have it.",
                  count,
                  analysis.ladder_count),
      svg);
}

Figure trade_off_figure(const TransmissionAnalysis& analysis) {
  return {.name = "trade-offs",
          .title = picture_title("Trade-offs", analysis.file, analysis.description),
          .description =
              "All transmissions that were found: largest torque of an element, largest "
              "speed of a shaft and unevenness of the steps over the mean efficiency.",
          .charts = {trade_off(analysis.all,
                               "Largest torque of an element by that of the input",
                               "torque",
                               &LadderFigures::element_torque),
                     trade_off(analysis.all,
                               "Largest speed of a shaft by that of the input",
                               "speed",
                               &LadderFigures::shaft_speed),
                     trade_off(analysis.all,
                               "Deviation of the logarithms of the steps from their mean",
                               "unevenness",
                               &LadderFigures::unevenness)}};
}

}  // namespace kinestat
