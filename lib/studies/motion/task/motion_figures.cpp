#include "studies/motion/task/motion_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/tolerance.hpp"
#include "math/numbers/settled.hpp"

namespace kinestat {

namespace {

// Columns beyond are read at the steps alone: to look between them takes several positions each.
constexpr std::size_t kMostRefined = 400;

// Peaks of one column that are looked at more closely, the most promising first.
constexpr std::size_t kMostPeaks = 3;

// Each parabola squares the error of the one before.
constexpr int kMostParabolas = 6;

// A value at a share of the ranges, with its sign turned where the least is looked for.
struct Sample {
  double share = 0.0;
  double value = 0.0;
};

using Triple = std::array<Sample, 3>;

// The share at which the parabola through three samples is greatest, and its value there; empty
// where it opens upwards, or is a line to rounding.
std::optional<Sample> vertex_of(const Triple& by) {
  const double low = by[0].share - by[1].share;
  const double high = by[2].share - by[1].share;
  const double low_slope = (by[0].value - by[1].value) / low;
  const double high_slope = (by[2].value - by[1].value) / high;
  const double bend = (high_slope - low_slope) / (high - low);
  if (!(bend < 0.0)) {
    return std::nullopt;
  }
  const double slope = low_slope - bend * low;
  const double at = -slope / (2.0 * bend);
  return Sample{.share = by[1].share + at, .value = by[1].value + at * (slope + bend * at)};
}

class FigureMaker {
 public:
  FigureMaker(std::span<const double> shares, const BetweenSteps& between, MotionTable& table)
      : shares_(shares), between_(between), table_(table) {
    for (const MotionRow& row : table.rows) {
      places_.push_back(&row.values);
    }
    for (const MotionEvent& event : table.events) {
      if (!event.places.empty()) {
        places_.push_back(&event.places);
      }
    }
  }

  void run() {
    table_.looks_between_steps = between_ && table_.columns.size() <= kMostRefined;
    for (std::size_t c = 0; c < table_.columns.size(); ++c) {
      table_.figures.push_back(
          {.least = extreme(c, -1.0), .greatest = extreme(c, 1.0), .mean = mean(c)});
    }
  }

 private:
  std::optional<ColumnExtreme> extreme(std::size_t column, double sign) {
    std::optional<ColumnExtreme> found;
    for (const std::vector<std::optional<double>>* place : places_) {
      const std::optional<double>& value = (*place)[column];
      if (value && (!found || sign * *value > sign * found->value)) {
        found = ColumnExtreme{.value = *value, .drive = (*place)[0].value_or(0.0)};
      }
    }
    if (found && table_.looks_between_steps && column >= table_.drives.size()) {
      climb(column, sign, *found);
    }
    return found;
  }

  void climb(std::size_t column, double sign, ColumnExtreme& found) {
    std::vector<std::pair<double, Triple>> peaks;  // with what their parabola promises
    for (std::size_t r = 1; r + 1 < table_.rows.size(); ++r) {
      const std::optional<Triple> triple = samples(column, sign, r);
      const std::optional<Sample> top = triple ? vertex_of(*triple) : std::nullopt;
      if (top && is_better(top->value, sign * found.value) && top->share > triple->front().share &&
          top->share < triple->back().share) {
        peaks.emplace_back(top->value, *triple);
      }
    }
    std::ranges::stable_sort(peaks, std::greater<>(), &std::pair<double, Triple>::first);
    for (std::size_t i = 0; i < std::min(peaks.size(), kMostPeaks); ++i) {
      const Sample top = top_of(column, sign, peaks[i].second);
      if (is_better(top.value, sign * found.value)) {
        found = {.value = sign * top.value, .drive = drive_at(top.share)};
      }
    }
  }

  std::optional<Triple> samples(std::size_t column, double sign, std::size_t middle) const {
    Triple triple;
    for (std::size_t i = 0; i < triple.size(); ++i) {
      const std::size_t row = middle + i - 1;
      const std::optional<double>& value = table_.rows[row].values[column];
      if (!value) {
        return std::nullopt;
      }
      triple[i] = {.share = shares_[row], .value = sign * *value};
    }
    return triple;
  }

  Sample top_of(std::size_t column, double sign, Triple by) const {
    Sample best = *std::ranges::max_element(by, {}, &Sample::value);
    for (int i = 0; i < kMostParabolas; ++i) {
      const std::optional<Sample> promised = vertex_of(by);
      const double width = by[2].share - by[0].share;
      const bool is_inside =
          promised && promised->share > by[0].share && promised->share < by[2].share;
      if (!is_inside || std::abs(promised->share - by[1].share) < kSameValue * width) {
        break;
      }
      const auto row = std::ranges::upper_bound(shares_, promised->share) - shares_.begin() - 1;
      const std::optional<double> value =
          between_(column, static_cast<std::size_t>(row), promised->share);
      if (!value) {
        break;
      }
      const Sample next{.share = promised->share, .value = sign * *value};
      const bool is_as_promised =
          !is_better(std::abs(next.value - promised->value), 0.0) ||
          std::abs(next.value - promised->value) <= kSameValue * std::abs(next.value);
      best = next.value > best.value ? next : best;
      narrow(next, by);
      if (is_as_promised) {
        break;
      }
    }
    return best;
  }

  // Keeps three samples of which the one in the middle is the greatest, where that can be.
  static void narrow(const Sample& next, Triple& by) {
    const bool is_behind = next.share > by[1].share;
    if (next.value > by[1].value) {
      by = is_behind ? Triple{by[1], next, by[2]} : Triple{by[0], next, by[1]};
    } else {
      by = is_behind ? Triple{by[0], by[1], next} : Triple{next, by[1], by[2]};
    }
  }

  static bool is_better(double value, double than) {
    return value - than > kSameValue * std::max(std::abs(value), std::abs(than));
  }

  // Of the first drive, in its unit.
  double drive_at(double share) const {
    const DriveTravel& drive = table_.drives.front();
    return drive.from + share * (drive.to - drive.from);
  }

  // Over the way of the drives: the trapezoids between the steps of a motion that reaches its end.
  std::optional<double> mean(std::size_t column) const {
    const bool has_all = table_.end == MotionEnd::complete && table_.rows.size() > 1 &&
                         std::ranges::all_of(table_.rows, [&](const MotionRow& row) {
                           return row.values[column].has_value();
                         });
    if (!has_all) {
      return std::nullopt;
    }
    const std::size_t last = table_.rows.size() - 1;
    double sum = 0.0;
    double size = 0.0;
    for (std::size_t row = 0; row <= last; ++row) {
      const double value = *table_.rows[row].values[column];
      const double term = row == 0 || row == last ? value / 2.0 : value;
      sum += term;
      size += std::abs(term);
    }
    return settled(sum, kCancellation * size) / static_cast<double>(last);
  }

  std::span<const double> shares_;
  const BetweenSteps& between_;
  MotionTable& table_;
  std::vector<const std::vector<std::optional<double>>*> places_;  // parallel to the columns
};

}  // namespace

void add_figures(std::span<const double> shares, const BetweenSteps& between, MotionTable& table) {
  FigureMaker(shares, between, table).run();
}

}  // namespace kinestat
