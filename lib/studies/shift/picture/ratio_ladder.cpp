#include "studies/shift/picture/ratio_ladder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "draw/axes.hpp"
#include "draw/picture_title.hpp"
#include "draw/text_styles.hpp"
#include "studies/shift/report/gear_report.hpp"

namespace kinestat {

namespace {

constexpr double kLadderHeight = 360.0;
constexpr double kRung = 70.0;
constexpr double kLeastColumn = 210.0;
constexpr double kTickSize = 11.0;
constexpr double kLabelDistance = 17.0;
constexpr double kNameGap = 23.0;  // from a rung to the ratio, but for the name between

struct Rung {
  std::string name;
  double ratio = 1.0;  // as it is, negative in reverse
};

// From the largest size of a ratio downwards.
struct Ladder {
  std::vector<Rung> forward;
  std::vector<Rung> reverse;
};

Ladder find_ladder(const Analysis& analysis) {
  Ladder ladder;
  const ShiftSolution& solution = analysis.shift->solution;
  for (std::size_t s = 0; s < solution.table.steps.size(); ++s) {
    const std::optional<double> ratio =
        gear_ratios(analysis, s, gear_values(analysis, s)).front().ratio.value;
    if (ratio && *ratio != 0.0) {
      (*ratio * solution.table.forward > 0.0 ? ladder.forward : ladder.reverse)
          .push_back({.name = solution.states[s].name, .ratio = *ratio});
    }
  }
  for (std::vector<Rung>* rungs : {&ladder.forward, &ladder.reverse}) {
    std::ranges::stable_sort(
        *rungs, [](const Rung& a, const Rung& b) { return std::abs(a.ratio) > std::abs(b.ratio); });
  }
  return ladder;
}

double name_width(const Rung& rung) {
  return text_width(rung.name, kTextSize, Weight::bold);
}

// Of what stands beside it, its name and its ratio.
double label_width(const Rung& rung) {
  return kNameGap + name_width(rung) + text_width(label_number(rung.ratio), kTextSize);
}

class LadderDrawing {
 public:
  explicit LadderDrawing(const Ladder& ladder) : ladder_(ladder) {
    low_ = 1.0;
    high_ = 1.0;
    for (const std::vector<Rung>* rungs : {&ladder.forward, &ladder.reverse}) {
      for (const Rung& rung : *rungs) {
        column_ = std::max(column_, kRung + label_width(rung) + 20.0);
        low_ = std::min(low_, std::abs(rung.ratio));
        high_ = std::max(high_, std::abs(rung.ratio));
      }
    }
    // Some room beyond the outermost rungs.
    low_ /= 1.15;
    high_ *= 1.15;
  }

  Svg run() {
    draw_axis();
    double left = 0.0;
    for (const auto& [title, rungs] :
         {std::pair{"forward", &ladder_.forward}, std::pair{"reverse", &ladder_.reverse}}) {
      if (!rungs->empty()) {
        draw_column(title, *rungs, left);
        left += column_;
      }
    }
    return std::move(svg_);
  }

 private:
  double place(double ratio) const {
    return kLadderHeight * std::log(high_ / std::abs(ratio)) / std::log(high_ / low_);
  }

  void draw_axis() {
    const bool has_both = !ladder_.forward.empty() && !ladder_.reverse.empty();
    const double right = (has_both ? column_ : 0.0) + kRung + 60.0;
    for (const double tick : ratio_ticks(low_, high_)) {
      svg_.line({.x = -10.0, .y = place(tick)},
                {.x = right, .y = place(tick)},
                {.stroke = Ink::grid, .width = 1.0});
      svg_.text({.x = -16.0, .y = place(tick) + 4.0},
                label_number(tick),
                {.ink = Ink::soft, .size = kTickSize, .anchor = Anchor::end});
    }
    svg_.text({.x = -52.0, .y = kLadderHeight / 2},
              "magnitude of the ratio",
              {.size = kTextSize, .anchor = Anchor::middle, .turn = -90.0});
  }

  void draw_column(const char* title, const std::vector<Rung>& rungs, double left) {
    svg_.text({.x = left + kRung / 2, .y = -16.0},
              title,
              {.size = kTextSize, .weight = Weight::bold, .anchor = Anchor::middle});
    for (const double x : {left, left + kRung}) {
      svg_.line({.x = x, .y = place(rungs.front().ratio) - 6.0},
                {.x = x, .y = place(rungs.back().ratio) + 6.0},
                {.stroke = Ink::soft, .width = 1.5});
    }
    std::vector<double> wished;
    for (const Rung& rung : rungs) {
      wished.push_back(place(rung.ratio));
    }
    const std::vector<double> labels = spread_places(wished, kLabelDistance);
    for (std::size_t i = 0; i < rungs.size(); ++i) {
      draw_rung(rungs[i], left, labels[i]);
      if (i > 0) {
        draw_step(rungs[i - 1], rungs[i], left);
      }
    }
  }

  void draw_rung(const Rung& rung, double left, double label) {
    const double y = place(rung.ratio);
    const double right = left + kRung;
    svg_.line({.x = left, .y = y}, {.x = right, .y = y}, {.stroke = Ink::blue, .width = 3.0});
    svg_.line({.x = right + 3.0, .y = y},
              {.x = right + 14.0, .y = label},
              {.stroke = Ink::soft, .width = 0.75});
    svg_.text({.x = right + 17.0, .y = label + 4.0},
              rung.name,
              {.size = kTextSize, .weight = Weight::bold, .has_halo = true});
    svg_.text({.x = right + kNameGap + name_width(rung), .y = label + 4.0},
              label_number(rung.ratio),
              {.size = kTextSize, .has_halo = true});
  }

  // Between two rungs, if there is room for it.
  void draw_step(const Rung& upper, const Rung& lower, double left) {
    const double top = place(upper.ratio);
    const double bottom = place(lower.ratio);
    if (bottom - top >= kTickSize + 5.0) {
      svg_.text({.x = left + kRung / 2, .y = (top + bottom) / 2 + 4.0},
                "÷ " + label_number(upper.ratio / lower.ratio, 3),
                {.ink = Ink::soft, .size = kTickSize, .anchor = Anchor::middle, .has_halo = true});
    }
  }

  const Ladder& ladder_;
  double low_ = 1.0;
  double high_ = 1.0;
  double column_ = kLeastColumn;  // from one to the next
  Svg svg_;
};

}  // namespace

bool has_ratios(const Analysis& analysis) {
  if (!analysis.shift) {
    return false;
  }
  const Ladder ladder = find_ladder(analysis);
  return !ladder.forward.empty() || !ladder.reverse.empty();
}

Picture draw_ratio_ladder(const Analysis& analysis) {
  KINESTAT_EXPECTS(has_ratios(analysis));
  const Svg svg = LadderDrawing(find_ladder(analysis)).run();
  return make_picture("ratio-ladder",
                      picture_title("Ratios of the gears", analysis),
                      "The ratio of each gear on a logarithmic scale; between neighbours the step.",
                      svg);
}

}  // namespace kinestat
