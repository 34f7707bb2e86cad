#include "studies/motion/task/figures/motion_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>

#include "core/motion_tolerance.hpp"
#include "core/solve_status.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "studies/motion/peak_search.hpp"
#include "studies/motion/task/figures/column_means.hpp"
#include "studies/motion/task/figures/motion_steps.hpp"
#include "studies/motion/task/figures/value_ends.hpp"

namespace kinestat {

namespace {

// A position no farther from a step than this says no more than the step how a column turns.
constexpr double kBesideStep = 0.05;

class FigureMaker {
 public:
  FigureMaker(std::span<const double> shares,
              std::span<const double> steps,
              const FigurePlaces& places,
              const std::vector<FigureColumn>& columns,
              const BetweenSteps& between,
              const std::function<FigureWhere(double)>& where_at,
              const std::function<double(double)>& share_at,
              MotionTable& table)
      : steps_(steps),
        corners_(places.places),
        pieces_(places.pieces),
        turns_(places.turns),
        columns_(columns),
        between_(between),
        where_at_(where_at),
        share_at_(share_at),
        table_(table) {
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      samples_.push_back({.step = steps[r],
                          .share = shares[r],
                          .place = steps[r],
                          .values = &table.rows[r].values,
                          .at_rest = &table.rows[r].at_rest,
                          .is_rounded = is_rounded(table.rows[r])});
    }
    for (const FigurePlace& place : places.places) {
      samples_.push_back({.step = place.step,
                          .share = place.share,
                          .place = place.is_approach ? place.beside : place.step,
                          .values = &place.of.values,
                          .at_rest = &place.of.at_rest,
                          .is_corner = true,
                          .is_approach = place.is_approach,
                          .weight = place.weight,
                          .is_for_peaks = place.is_for_peaks});
    }
    std::ranges::stable_sort(samples_, {}, &Sample::step);
    find_dwells();
  }

  void run() {
    for (std::size_t c = 0; c < table_.columns.size(); ++c) {
      double& usual = usual_[table_.columns[c].unit];
      for (const MotionRow& row : table_.rows) {
        usual = std::max(usual, std::abs(row.values[c].value_or(0.0)));
      }
    }
    for (std::size_t c = 0; c < table_.columns.size(); ++c) {
      const Growth growth = look_at_ends(c);
      ColumnFigures& figures = table_.figures.emplace_back();
      figures.least = growth.falls ? std::nullopt : extreme(c, -1.0);
      figures.greatest = growth.grows ? std::nullopt : extreme(c, 1.0);
      if (growth.has_any() || (is_bounded(c) && ends_on_the_way(c))) {
        continue;
      }
      const ColumnMeans means = means_of_column(c);
      figures.mean = means.mean;
      if (c < columns_.size() && columns_[c].is_checked) {
        figures.mean_by_half = means_of_column(c, 2).mean;
      }
      figures.rms = table_.duration ? root(means.mean_square) : std::nullopt;
    }
  }

 private:
  struct Sample {
    double step = 0.0;
    double share = 0.0;
    double place = 0.0;  // in steps: of an approach that which it is beside
    const std::vector<std::optional<double>>* values = nullptr;
    const std::vector<std::optional<double>>* at_rest = nullptr;
    bool is_rounded = false;  // of a row: what it lacks would be rounding
    bool is_corner = false;
    bool is_approach = false;
    double weight = 0.0;  // of a point of a piece of time
    bool is_for_peaks = false;
    bool dwells = false;  // it rests there for a while, and not only where it turns back

    // Friction has no direction there.
    bool rests() const { return !at_rest->empty(); }

    std::optional<double> value_at_rest(std::size_t column) const {
      return at_rest->empty() ? std::nullopt : (*at_rest)[column];
    }

    // Whether it has no value for a while but one without friction.
    bool lacks_direction(std::size_t column) const { return dwells && !(*values)[column]; }

    std::optional<double> value(std::size_t column) const {
      return lacks_direction(column) ? value_at_rest(column) : (*values)[column];
    }
  };

  static bool is_rounded(const MotionRow& row) {
    return row.status == word_of(SolveStatus::solved) &&
           (row.drops_velocities || row.drops_accelerations || row.lacks_accelerations);
  }

  void find_dwells() {
    for (std::size_t first = 0; first < samples_.size();) {
      std::size_t end = first;
      while (end < samples_.size() && samples_[end].rests()) {
        ++end;
      }
      const bool dwells =
          end > first && samples_[end - 1].step - samples_[first].step > 2.0 * kSameApproach;
      for (std::size_t i = first; dwells && i < end; ++i) {
        samples_[i].dwells = true;
      }
      first = std::max(end, first + 1);
    }
  }

  // Whether rows lack it where friction has no direction, even without friction.
  bool is_open_at_rest(std::size_t column) const {
    return std::ranges::any_of(samples_, [column](const Sample& one) {
      return !one.is_corner && one.rests() && !(*one.values)[column] && !one.value_at_rest(column);
    });
  }

  // Those of the column: of the steps, and of the corners at which it has a value.
  std::vector<Sample> samples_of(std::size_t column) const {
    std::vector<Sample> found;
    const bool is_open = is_open_at_rest(column);
    for (const Sample& one : samples_) {
      if (!one.is_corner || (*one.values)[column] || one.value_at_rest(column) ||
          (is_open && one.rests())) {
        found.push_back(one);
      }
    }
    return found;
  }

  // Without approaches to places where the column does not jump: steps of one length integrate a
  // smooth turn far better. For peaks one of both sides says more of how the column turns between
  // the steps.
  std::vector<Sample> samples_with_jumps(std::size_t column, bool for_peaks) const {
    std::vector<Sample> all = samples_of(column);
    double largest = 0.0;
    for (const Sample& one : all) {
      largest = std::max(largest, std::abs(one.value(column).value_or(0.0)));
    }
    const auto jumps_between = [&](const Sample& one, const Sample& other) {
      const std::optional<double> here = one.value(column);
      const std::optional<double> there = other.value(column);
      return !here || !there || std::abs(*here - *there) > kJump * largest;
    };
    std::vector<Sample> kept;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto jumps_to = [&](std::size_t other) {
        return other < all.size() && std::abs(all[other].step - all[i].step) < kSameApproach &&
               jumps_between(all[i], all[other]);
      };
      if (!for_peaks && (all[i].is_for_peaks || (all[i].is_corner && is_smooth(column)))) {
        continue;
      }
      // What is smooth beside it in time ends there, if nothing else stands at the place.
      const auto stands_by = [&](std::size_t other) {
        return other < all.size() && std::abs(all[other].step - all[i].step) < kSameApproach &&
               !all[other].is_approach;
      };
      const bool is_alone = !for_peaks && table_.duration && turns_sharply_at(all[i].place) &&
                            !stands_by(i - 1) && !stands_by(i + 1);
      const bool is_between = for_peaks && all[i].step < all[i].place &&
                              std::abs(all[i].step - std::round(all[i].step)) > kBesideStep;
      if (!all[i].is_approach || is_between || is_alone || jumps_to(i - 1) || jumps_to(i + 1)) {
        kept.push_back(all[i]);
      }
    }
    return kept;
  }

  bool turns_sharply_at(double step) const {
    const auto behind = std::ranges::lower_bound(turns_, step - kSameStep);
    return behind != turns_.end() && *behind <= step + kSameStep;
  }

  std::optional<ColumnExtreme> extreme(std::size_t column, double sign) {
    std::optional<ColumnExtreme> found;
    const auto look = [&](const std::optional<double>& value, double drive, double row) {
      if (value && (!found || sign * *value > sign * found->value)) {
        found = ColumnExtreme{.value = *value, .drive = drive, .row = row};
      }
    };
    for (const Sample& one : samples_) {
      look(one.value(column), (*one.values)[0].value_or(0.0), row_at(steps_, one.place));
    }
    for (const MotionEvent& event : table_.events) {
      if (!event.places.empty()) {
        look(event.places[column], event.places[0].value_or(0.0), event.row);
      }
    }
    for (const ColumnExtreme& end : ends_) {
      if (found && sign * end.value > sign * found->value) {
        found = end;
      }
    }
    if (found && is_climbed(column)) {
      climb(column, sign, *found);
    }
    return found;
  }

  ColumnExtreme extreme_at(double value, double share) const {
    const FigureWhere where = where_at_(share);
    return {.value = value, .drive = where.drive, .row = row_at(steps_, where.step)};
  }

  // What acts turns round or jumps at corners, and so do the laws of drives.
  bool is_smooth(std::size_t column) const { return is_of_motion(column) && !table_.duration; }

  bool is_of_motion(std::size_t column) const {
    return column < columns_.size() && columns_[column].is_of_motion;
  }

  bool is_climbed(std::size_t column) const {
    return column < columns_.size() && columns_[column].is_climbed;
  }

  bool is_bounded(std::size_t column) const {
    return column < columns_.size() && columns_[column].is_bounded;
  }

  // Whether rows lack it for another reason than that friction has no direction in them.
  bool ends_on_the_way(std::size_t column) const {
    return std::ranges::any_of(table_.rows, [column](const MotionRow& row) {
      return !row.values[column] && row.status != kFrictionReversalEvent &&
             row.status != word_of(SolveStatus::at_rest);
    });
  }

  void climb(std::size_t column, double sign, ColumnExtreme& found) {
    const std::vector<Sample> samples = samples_with_jumps(column, true);
    const auto joins_next = [&](std::size_t i) {  // not the other side of a jump
      return i + 1 < samples.size() && samples[i + 1].step - samples[i].step >= kSameApproach &&
             samples[i + 1].lacks_direction(column) == samples[i].lacks_direction(column);
    };
    const std::optional<ValueFolds>& folds = columns_[column].folds;
    const auto fold = [&] { return sign > 0.0 ? folds->greatest : -folds->least; };
    const bool is_size = !folds && std::ranges::none_of(samples, [column, sign](const Sample& one) {
      return sign * one.value(column).value_or(0.0) > 0.0;
    });
    PeakSearch search(sign * found.value, folds ? std::optional(fold()) : std::nullopt, is_size);
    std::vector<PeakSample> run;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const std::optional<double> value = samples[i].value(column);
      if (value) {
        run.push_back({.share = samples[i].share, .value = sign * *value});
      }
      if (!value || !joins_next(i)) {
        search.add_run(run);
        run.clear();
      }
    }
    while (const std::optional<double> share = search.next()) {
      const std::optional<double> value = between_.value(column, *share, Look::peak);
      search.take(value ? std::optional(sign * *value) : std::nullopt);
    }
    if (const std::optional<PeakSample> top = search.better()) {
      found = extreme_at(sign * top->value, top->share);
    }
  }

  static std::optional<double> root(const std::optional<double>& square) {
    return square ? std::optional(std::sqrt(*square)) : std::nullopt;
  }

  // Of a motion that reaches its end; of one in so many of its steps.
  ColumnMeans means_of_column(std::size_t column, int every = 1) {
    if (!table_.is_whole() || table_.rows.size() < 2) {
      return {};
    }
    std::vector<MeanSample> samples;
    int steps = 0;
    for (const Sample& one : samples_with_jumps(column, false)) {
      const bool is_inside = one.step > steps_.front() && one.step < steps_.back();
      if (!one.is_corner && steps++ % every != 0 && is_inside) {
        continue;
      }
      if (!one.is_rounded || !is_inside || one.value(column)) {
        samples.push_back({.step = one.step,
                           .value = one.value(column),
                           .rests = one.rests(),
                           .weight = one.weight});
      }
    }
    const MeanCourse course{
        .pieces = pieces_,
        .corners = turns_,
        .ends_at_limit = !table_.duration && table_.rows.back().status == kLimitEvent};
    return means_of(
        samples,
        course,
        [&](double from, double end, double left) { return mean_before(column, from, end, left); },
        integral_);
  }

  // Near a limit rounding may leave values open, too; they are known farther from it.
  std::optional<double> mean_before(std::size_t column,
                                    double from,
                                    double end,
                                    double left) const {
    constexpr double kFarthest = 0.9;
    const auto row = std::ranges::find(steps_, end) - steps_.begin();
    const bool is_singular =
        row < std::ssize(steps_) && is_at_singular(static_cast<std::size_t>(row));
    std::optional<double> value = value_before(column, from, end, left);
    while (!value && is_singular && left < kFarthest) {
      left = std::midpoint(left, 1.0);
      value = value_before(column, from, end, left);
    }
    return value;
  }

  bool is_at_singular(std::size_t row) const {
    const std::string& status = table_.rows[row].status;
    return status == kLimitEvent || status == kSingularEvent;
  }

  // So much of the way from a step with a value is left to the end, which has none.
  std::optional<double> value_before(
      std::size_t column, double from, double end, double left, Look look = Look::mean) const {
    const double here = std::lerp(end, from, left);
    return between_.value ? between_.value(column, share_at_(here), look) : std::nullopt;
  }

  // So near, what grows without bound is far above all that rows have in its unit; and rounding is
  // below that.
  Growth growth_at_pole(const std::array<double, 3>& values, std::size_t column) const {
    constexpr double kFarAbove = 16.0;
    const auto [far, near, nearest] = values;
    const double usual = usual_.at(table_.columns[column].unit);
    const bool is_far_above = usual > 0.0 && std::abs(nearest) > kFarAbove * usual &&
                              far * near > 0.0 && near * nearest > 0.0;
    return is_far_above ? growth_of(values) : Growth{};
  }

  // Between a position that has values and one that has none.
  void look_towards(std::size_t column, std::size_t from, std::size_t end, Growth& growth) {
    const auto value = [&](double left) {
      return value_before(column, steps_[from], steps_[end], left, Look::end);
    };
    const bool is_singular = is_at_singular(end);
    const auto is_lost = [&](double left) {
      const double step = std::lerp(steps_[end], steps_[from], left);
      return is_singular && (is_of_motion(column) || !between_.is_jammed(share_at_(step)));
    };
    double size = 0.0;
    for (const Sample& one : samples_) {
      size = std::max(size, std::abs((*one.values)[column].value_or(0.0)));
    }
    const ValueEnd found = find_value_end(value, size, is_lost);
    growth.falls = growth.falls || (found.growth.falls && !is_bounded(column));
    growth.grows = growth.grows || (found.growth.grows && !is_bounded(column));
    if (found.value) {
      const double step = std::lerp(steps_[end], steps_[from], found.left);
      ends_.push_back(extreme_at(*found.value, share_at_(step)));
    }
  }

  // Whether a place between two steps is approached, and the column has a value there.
  bool is_approached(double low, double high, std::size_t column) const {
    return std::ranges::any_of(corners_, [&](const FigurePlace& place) {
      return place.is_approach && place.step > low && place.step < high && place.of.values[column];
    });
  }

  // Whether values grow without bound, or fall, towards a position that has none; and what those
  // come to that do not.
  Growth look_at_ends(std::size_t column) {
    Growth growth;
    ends_.clear();
    const std::vector<MotionRow>& rows = table_.rows;
    for (std::size_t r = 0; between_.value && r + 1 < rows.size(); ++r) {
      const bool has_this = rows[r].values[column].has_value();
      if (has_this == rows[r + 1].values[column].has_value()) {
        continue;
      }
      // Where friction turns round values jump, and what they come to is known.
      const std::size_t end = has_this ? r + 1 : r;
      const bool turns_round =
          rows[end].status != kLimitEvent && is_approached(steps_[r], steps_[r + 1], column);
      if (!turns_round) {
        look_towards(column, has_this ? r : r + 1, end, growth);
      }
    }
    for (const FigurePlace& place : corners_) {
      if (!is_bounded(column) && !place.farther.empty() && place.farther[0][column] &&
          place.farther[1][column] && place.of.values[column]) {
        const Growth pole = growth_at_pole(
            {*place.farther[0][column], *place.farther[1][column], *place.of.values[column]},
            column);
        growth.falls = growth.falls || pole.falls;
        growth.grows = growth.grows || pole.grows;
      }
    }
    return growth;
  }

  std::map<std::string, double> usual_;  // the largest value of the rows, by units
  std::span<const double> steps_;        // of the rows
  std::span<const FigurePlace> corners_;
  std::span<const TimePiece> pieces_;
  std::span<const double> turns_;
  const std::vector<FigureColumn>& columns_;
  const BetweenSteps& between_;
  const std::function<FigureWhere(double)>& where_at_;
  const std::function<double(double)>& share_at_;
  MotionTable& table_;
  std::vector<Sample> samples_;      // steps and corners, in order
  SmoothIntegral integral_;          // of means
  std::vector<ColumnExtreme> ends_;  // of the column that is looked at
};

}  // namespace

void add_figures(std::span<const double> shares,
                 std::span<const double> steps,
                 const FigurePlaces& places,
                 const std::vector<FigureColumn>& columns,
                 const BetweenSteps& between,
                 const std::function<FigureWhere(double share)>& where_at,
                 const std::function<double(double step)>& share_at,
                 MotionTable& table) {
  FigureMaker(shares, steps, places, columns, between, where_at, share_at, table).run();
}

}  // namespace kinestat
