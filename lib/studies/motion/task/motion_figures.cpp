#include "studies/motion/task/motion_figures.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "math/numbers/settled.hpp"
#include "studies/motion/peak_search.hpp"

namespace kinestat {

namespace {

class FigureMaker {
 public:
  FigureMaker(std::span<const double> shares,
              const std::vector<std::optional<ClimbedColumn>>& climbed,
              const BetweenSteps& between,
              const std::function<double(double)>& drive_at,
              const std::function<double(std::size_t)>& middle_behind,
              MotionTable& table)
      : shares_(shares),
        climbed_(climbed),
        between_(between),
        drive_at_(drive_at),
        middle_behind_(middle_behind),
        table_(table) {
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
    for (std::size_t c = 0; c < table_.columns.size(); ++c) {
      table_.figures.push_back(
          {.least = extreme(c, -1.0),
           .greatest = extreme(c, 1.0),
           .mean = mean(c, [](double value) { return value; }),
           .rms = table_.duration ? root(mean(c, [](double value) { return value * value; }))
                                  : std::nullopt});
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
    if (found && column < climbed_.size() && climbed_[column]) {
      climb(column, sign, *found);
    }
    return found;
  }

  void climb(std::size_t column, double sign, ColumnExtreme& found) {
    const auto sample = [&](std::size_t row) -> std::optional<PeakSample> {
      const std::optional<double> value =
          row < table_.rows.size() ? table_.rows[row].values[column] : std::nullopt;
      return value ? std::optional(PeakSample{.share = shares_[row], .value = sign * *value})
                   : std::nullopt;
    };
    PeakSearch search(sign * found.value, sign > 0.0 ? climbed_[column]->fold : std::nullopt);
    for (std::size_t r = 1; r + 1 < table_.rows.size(); ++r) {
      const std::optional<PeakSample> before = sample(r - 1);
      const std::optional<PeakSample> there = sample(r);
      const std::optional<PeakSample> behind = sample(r + 1);
      if (!before || !there || !behind) {
        continue;
      }
      const bool is_first = r < 2 || !sample(r - 2);
      const bool is_last = !sample(r + 2);
      if (may_be_peak(before->value, there->value, behind->value, is_first, is_last)) {
        search.add({*before, *there, *behind});
      }
    }
    while (const std::optional<double> share = search.next()) {
      const auto row = std::ranges::upper_bound(shares_, *share) - shares_.begin() - 1;
      const std::optional<double> value = between_(column, static_cast<std::size_t>(row), *share);
      search.take(value ? std::optional(sign * *value) : std::nullopt);
    }
    if (const std::optional<PeakSample> top = search.better()) {
      found = {.value = sign * top->value, .drive = drive_at_(top->share)};
    }
  }

  static std::optional<double> root(const std::optional<double>& square) {
    return square ? std::optional(std::sqrt(*square)) : std::nullopt;
  }

  // Over the way of the drives, or in time: the trapezoids between the steps of a motion that
  // reaches its end, or the middle where an end has no value.
  template <class Measure>
  std::optional<double> mean(std::size_t column, const Measure& measure) const {
    const bool is_whole = table_.end == MotionEnd::complete ||
                          (table_.end == MotionEnd::limited && table_.until_limit);
    if (!is_whole || table_.rows.size() < 2) {
      return std::nullopt;
    }
    const std::size_t last = table_.rows.size() - 1;
    double sum = 0.0;
    double size = 0.0;
    const auto add = [&](double value, double weight) {
      sum += weight * measure(value);
      size += weight * std::abs(measure(value));
    };
    for (std::size_t row = 0; row < last; ++row) {
      const std::optional<double>& low = table_.rows[row].values[column];
      const std::optional<double>& high = table_.rows[row + 1].values[column];
      if (low && high) {
        add(*low, 0.5);
        add(*high, 0.5);
        continue;
      }
      const std::optional<double> middle =
          (low || high) && between_ ? between_(column, row, middle_behind_(row)) : std::nullopt;
      if (!middle) {
        return std::nullopt;
      }
      add(*middle, 1.0);
    }
    return settled(sum, kCancellation * size) / static_cast<double>(last);
  }

  std::span<const double> shares_;
  const std::vector<std::optional<ClimbedColumn>>& climbed_;
  const BetweenSteps& between_;
  const std::function<double(double)>& drive_at_;
  const std::function<double(std::size_t)>& middle_behind_;
  MotionTable& table_;
  std::vector<const std::vector<std::optional<double>>*> places_;  // parallel to the columns
};

}  // namespace

void add_figures(std::span<const double> shares,
                 const std::vector<std::optional<ClimbedColumn>>& climbed,
                 const BetweenSteps& between,
                 const std::function<double(double share)>& drive_at,
                 const std::function<double(std::size_t row)>& middle_behind,
                 MotionTable& table) {
  FigureMaker(shares, climbed, between, drive_at, middle_behind, table).run();
}

}  // namespace kinestat
