#include "studies/sweep/motion/state_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "cases/case_status.hpp"
#include "studies/motion/task/find_motion.hpp"
#include "studies/motion/task/motion_findings.hpp"
#include "studies/sweep/report/sweep_status.hpp"

namespace kinestat {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view kSolved = "solved";

// Said of the drawn position, which the motion closes, and of friction, whose rows say it too where
// they have no actions.
bool decides_nothing(std::string_view code) {
  return code == "W0504" || code == "W0508";
}

// The value of a figure over all positions.
class FigureReader {
 public:
  explicit FigureReader(const MotionTable& motion) : motion_(motion) {}

  // Empty where the table has no such column.
  std::optional<std::size_t> column_of(const SweptFigure& asked) const {
    const auto at = std::ranges::find_if(
        motion_.columns, [&](const MotionColumn& one) { return one.name() == asked.column; });
    return at == motion_.columns.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(at - motion_.columns.begin()));
  }

  double dead_points(const std::string& freedom) const {
    return static_cast<double>(std::ranges::count_if(motion_.events, [&](const MotionEvent& one) {
      return one.kind == kDeadPointEvent && one.reverses &&
             (freedom.empty() || one.element == freedom);
    }));
  }

  double value(MotionFigure figure, std::size_t column) const {
    const ColumnFigures& figures = motion_.figures[column];
    const double least = figures.least ? figures.least->value : kNone;
    const double greatest = figures.greatest ? figures.greatest->value : kNone;
    switch (figure) {
      case MotionFigure::least:
        return least;
      case MotionFigure::greatest:
        return greatest;
      case MotionFigure::range:
        return greatest - least;
      case MotionFigure::mean:
        return figures.mean.value_or(kNone);
      case MotionFigure::rms:
        return figures.rms.value_or(kNone);
      case MotionFigure::peak:
        return figures.least && figures.greatest ? std::max(std::abs(least), std::abs(greatest))
                                                 : kNone;
      case MotionFigure::dead_points:
      case MotionFigure::overall_efficiency:
        break;
    }
    return kNone;
  }

 private:
  const MotionTable& motion_;
};

// The first position that has no value in that column, of those that matter.
template <class Matters>
const MotionRow* find_gap(const MotionTable& motion, std::size_t column, const Matters& matters) {
  const auto at = std::ranges::find_if(motion.rows, [&](const MotionRow& row) {
    return !row.values[column].has_value() && matters(row);
  });
  return at == motion.rows.end() ? nullptr : &*at;
}

std::string_view code_of(const Diagnostics& found, Severity severity) {
  const auto at = std::ranges::find_if(found.items(), [&](const Diagnostic& one) {
    return one.severity == severity && !decides_nothing(one.code);
  });
  return at == found.items().end() ? std::string_view() : at->code;
}

}  // namespace

StateMotion::StateMotion(const SweptMotion& asked, std::span<const SweepColumn> columns)
    : asked_(asked), columns_(columns), values_(asked.figures.size(), kNone) {}

void StateMotion::fill(const MechanismDescription& description,
                       const Mechanism& mechanism,
                       std::span<SweepRow> rows) {
  std::optional<FoundMotion> motion;
  std::string status;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || asked_.is_of_case) {
      status = move(description, mechanism, i, motion);
    }
    show(status, rows[i]);
  }
}

// Answers the status; `motion` is that of the row before, of which this one has the positions
// unless the case decides how drives run.
std::string StateMotion::move(const MechanismDescription& description,
                              const Mechanism& mechanism,
                              std::size_t row,
                              std::optional<FoundMotion>& motion) {
  std::ranges::fill(values_, kNone);
  const std::optional<int> which = asked_.case_of(row);
  MotionPlan plan = *bind_motion(description, mechanism, which);
  const bool is_in_time = plan.schedule || plan.time_problem != TimeProblem::none;
  const bool was_in_time = motion && motion->plan.schedule;
  plan.which = which.value_or(-1);
  plan.report = asked_.report;
  if (motion && !is_in_time && !was_in_time) {
    motion->plan.which = plan.which;
  } else {
    Diagnostics found;
    motion = follow_motion(description, mechanism, std::move(plan), found);
    if (!motion) {
      return std::string(code_of(found, Severity::error));
    }
  }
  return find_figures(description, mechanism, *motion);
}

// Answers whether all that is asked for is right, and if not, why. What is found of the case in a
// position is the status of that position.
std::string StateMotion::find_figures(const MechanismDescription& description,
                                      const Mechanism& mechanism,
                                      FoundMotion& motion) {
  std::ranges::fill(values_, kNone);
  PositionFindings of_positions;
  motion.table = make_motion_table(description, mechanism, motion, asked_.scope, of_positions);
  Diagnostics found;
  add_findings(motion, description, mechanism, {}, found);
  const MotionTable& table = motion.table;
  const bool ends_early = std::ranges::any_of(
      found.items(), [](const Diagnostic& one) { return one.code == kEndsAtLimit; });
  if (found.has_errors() || ends_early) {
    return std::string(word_of(table.end));
  }
  // Where nothing is open but the direction of friction, and at the limit to which it goes, figures
  // are those of the rows about it.
  const bool rests = table.duration && !of_positions.has_errors();
  const auto is_open = [&](const std::string& status) {
    return status != kFrictionReversalEvent && !(table.until_limit && status == kLimitEvent) &&
           !(rests && status == word_of(SolveStatus::at_rest));
  };
  const auto matters = [&](const MotionRow& row) { return is_open(row.status); };
  const FigureReader reader(table);
  const MotionRow* gap = nullptr;
  bool lacks_efficiency = false;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const SweptFigure& asked = asked_.figures[i];
    if (asked.figure == MotionFigure::dead_points) {
      values_[i] = table.may_lack_dead_points ? kNone : reader.dead_points(asked.column);
      continue;
    }
    if (asked.figure == MotionFigure::overall_efficiency) {
      values_[i] = table.overall_efficiency.value_or(kNone);
      lacks_efficiency = !table.overall_efficiency;
      continue;
    }
    const std::optional<std::size_t> column = reader.column_of(asked);
    const MotionRow* missing = column ? find_gap(table, *column, matters) : nullptr;
    gap = gap != nullptr ? gap : missing;
    if (column && missing == nullptr) {
      values_[i] = reader.value(asked.figure, *column);
    }
  }
  if (gap != nullptr && gap->status != kSolved) {
    return gap->status;
  }
  const auto unsolved = std::ranges::find_if(
      table.rows, [&](const MotionRow& one) { return one.status != kSolved && matters(one); });
  if (unsolved != table.rows.end()) {
    return unsolved->status;
  }
  const auto between = std::ranges::find_if(table.between, is_open);
  if (between != table.between.end()) {
    return *between;
  }
  const std::string_view warning = code_of(found, Severity::warning);
  const bool lacks_some = std::ranges::any_of(values_, [](double one) { return std::isnan(one); });
  return std::string(!warning.empty()   ? warning
                     : lacks_efficiency ? kNoEfficiency
                     : lacks_some       ? kNoNumber
                                        : kSolved);
}

void StateMotion::show(std::string_view status, SweepRow& row) {
  for (std::size_t q = 0; q < columns_.size(); ++q) {
    if (columns_[q].kind == SweepColumnKind::motion) {
      row.values[q] = values_[static_cast<std::size_t>(columns_[q].index)];
    }
  }
  if (row.status == kSolved && status != kSolved) {
    const auto at = statuses_.find(status);
    row.status = at != statuses_.end() ? *at : *statuses_.emplace(status).first;
  }
}

}  // namespace kinestat
