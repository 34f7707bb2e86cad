#include "studies/motion/report/motion_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "core/utf8.hpp"
#include "mechanism/couplings/coupling_reactions.hpp"
#include "report/column_table.hpp"
#include "report/number_format.hpp"
#include "studies/motion/report/motion_dynamics_text.hpp"
#include "studies/motion/report/motion_time.hpp"

namespace kinestat {

namespace {

// More nobody reads; the whole table is in the other forms.
constexpr int kMostRows = 13;
constexpr std::size_t kMostColumns = 6;
constexpr std::size_t kMostEvents = 12;

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : fmt::format("{} [{}]", text, unit);
}

std::string amount(double value, const std::string& unit) {
  return unit.empty() ? format_short(value) : format_short(value) + " " + unit;
}

std::string shown(const std::optional<double>& value) {
  return value ? format_short(*value) : "-";
}

bool is_same(double least, double greatest) {
  return greatest - least <= kSameValue * std::max(std::abs(least), std::abs(greatest));
}

class MotionWriter {
 public:
  explicit MotionWriter(const MotionTable& motion) : motion_(motion) {}

  TextBlocks summary() const {
    TextBlocks text("Motion" + case_text() + "\n" + drives_text() + assembly_text() +
                    events_text() + closure_text() + "\n");
    text += extremes();
    return text += motion_dynamics_blocks(motion_);
  }

  TextBlocks remarks() const { return TextBlocks(closure_text() + assembly_text()); }

  TextBlocks run() const {
    TextBlocks text = summary();
    return text += positions();
  }

  // Of every quantity but the positions of the drives, which the file gives, and what is always 0.
  TextBlocks extremes() const {
    const bool by_time = is_told_by_time(motion_);
    const std::string at =
        by_time ? with_unit("at", motion_.time_unit) : "at " + motion_.drives.front().name;
    const std::string infinite = "infinite";
    std::vector<TextColumn> table = {{std::string(extremes_title()), {}},
                                     {"least", {}},
                                     {at, {}},
                                     {"greatest", {}},
                                     {at, {}},
                                     {"range", {}},
                                     {"mean", {}},
                                     {"RMS", {}}};
    std::vector<TextColumn> constants = {{"Does not change", {}}, {"value", {}}};
    std::vector<std::string> with_gaps;
    std::vector<std::string> with_poles;
    for (const std::size_t c : results_first()) {
      const ColumnFigures& figures = motion_.figures[c];
      const auto& [least, greatest, mean, rms] =
          std::tie(figures.least, figures.greatest, figures.mean, figures.rms);
      const bool is_time = motion_.duration && motion_.columns[c].quantity == kTimeColumn;
      const bool is_bounded = least && greatest;
      // Means leave out the approaches to places where friction turns round.
      const bool is_constant =
          is_bounded && is_same(least->value, greatest->value) &&
          (!mean || std::abs(*mean - least->value) <= kSameApproach * std::abs(least->value));
      if (is_time || !has_values(c) || (is_constant && least->value == 0.0)) {
        continue;
      }
      const std::string name = with_unit(motion_.columns[c].name(), motion_.columns[c].unit);
      if (is_constant) {
        constants[0].cells.push_back(name);
        constants[1].cells.push_back(format_short(least->value));
        continue;
      }
      if (!mean) {
        (is_bounded ? with_gaps : with_poles).push_back(motion_.columns[c].name());
      }
      const auto place_of = [&](const std::optional<ColumnExtreme>& one) {
        return !one      ? std::nullopt
               : by_time ? time_at_row(motion_, one->row)
                         : std::optional(one->drive);
      };
      const std::array cells = {
          name,
          least ? format_short(least->value) : "-" + infinite,
          shown(place_of(least)),
          greatest ? format_short(greatest->value) : infinite,
          shown(place_of(greatest)),
          is_bounded ? format_short(greatest->value - least->value) : infinite,
          shown(mean),
          shown(rms)};
      for (std::size_t i = 0; i < cells.size(); ++i) {
        table[i].cells.push_back(cells[i]);
      }
    }
    if (!motion_.duration) {
      table.pop_back();
    }
    const std::string lacks =
        motion_.is_whole() ? no_mean_text(with_gaps, "some positions have no value") +
                                 no_mean_text(with_poles,
                                              with_poles.size() == 1 ? "it becomes infinite"
                                                                     : "they become infinite")
        : !table[0].cells.empty() ? "  no means: the motion ends before its range does\n"
                                  : "";
    TextBlocks blocks;
    for (std::vector<TextColumn>* one : {&table, &constants}) {
      if (!one->front().cells.empty()) {
        blocks += TextBlocks(std::move(*one));
      }
    }
    const std::string below = lacks + overall_text();
    if (!below.empty()) {
      blocks += below + "\n";
    }
    return blocks;
  }

 private:
  // What actuators do and what passes through the mechanism, strokes, that of the output first,
  // what couplings bear, and then how everything moves; else as in the file.
  static int rank_of(const MotionColumn& column) {
    constexpr std::array<std::string_view, 6> kPassed = {
        "action", "power", "efficiency", "ratio", "transmission_angle", "mechanical_advantage"};
    constexpr std::array kBorne = {kReactionForce, kReactionFriction, kReactionLoss};
    const bool is_of_coupling = column.element.find('.') != std::string::npos;
    if (std::ranges::find(kPassed, column.quantity) != kPassed.end()) {
      return is_of_coupling ? 4 : 0;
    }
    return column.quantity == "position"                                ? (column.is_output ? 1 : 2)
           : std::ranges::find(kBorne, column.quantity) != kBorne.end() ? 3
                                                                        : 5;
  }

  std::vector<std::size_t> results_first() const {
    std::vector<std::size_t> columns;
    for (std::size_t c = motion_.drives.size(); c < column_count(); ++c) {
      columns.push_back(c);
    }
    std::ranges::stable_sort(
        columns, {}, [&](std::size_t c) { return rank_of(motion_.columns[c]); });
    return columns;
  }

  std::string overall_text() const {
    const std::string& why = motion_.no_overall_efficiency;
    return motion_.overall_efficiency ? fmt::format("  overall efficiency {}{}{}\n",
                                                    format_short(*motion_.overall_efficiency),
                                                    why.empty() ? ", of mean powers" : ": ",
                                                    why)
           : why.empty()              ? ""
                                      : fmt::format("  no overall efficiency: {}\n", why);
  }

  static std::string no_mean_text(const std::vector<std::string>& columns, std::string_view why) {
    return columns.empty() ? ""
                           : fmt::format("  no mean of {}: {}\n", fmt::join(columns, ", "), why);
  }

  // One without extremes has none because it becomes infinite on the way.
  bool has_values(std::size_t column) const {
    return std::ranges::any_of(
        motion_.rows, [column](const MotionRow& row) { return row.values[column].has_value(); });
  }

  std::string_view extremes_title() const {
    return motion_.looks_between_steps ? "Extremes" : "Extremes at steps and dead points";
  }

  std::string case_text() const {
    return motion_.label.empty()
               ? ""
               : fmt::format(", speeds and loads of case '{}'", printable(motion_.label));
  }

  std::string drives_text() const {
    std::string text;
    for (const DriveTravel& drive : motion_.drives) {
      text += fmt::format(
          "  {} ({}) from {} to {} in {} step{}{}{}\n",
          drive.name,
          drive.freedom,
          format_short(drive.from),
          amount(drive.to, drive.unit),
          motion_.steps,
          motion_.steps == 1 ? "" : "s",
          motion_.duration ? " and " + amount(*motion_.duration, motion_.time_unit) : "",
          end_text(drive));
    }
    return text;
  }

  std::string end_text(const DriveTravel& drive) const {
    const std::string where =
        drive.reached ? " at " + amount(*drive.reached, drive.unit) : std::string();
    switch (motion_.end) {
      case MotionEnd::complete:
        return "";
      case MotionEnd::limited:
        return ": reaches its limit" + where;
      case MotionEnd::drives_locked:
        return motion_.drives.size() > 1 ? ": cannot run with the others" : ": cannot run";
      case MotionEnd::lost:
        return ": could not be followed beyond" + (drive.reached ? where.substr(3) : " the start");
      case MotionEnd::not_assembled:
        return ": the drawn position cannot be assembled";
    }
    return "";
  }

  std::string closure_text() const {
    if (motion_.rows.empty()) {
      return "";
    }
    const std::string step =
        motion_.worst_closure <= kSameValue ? "" : fmt::format(" (step {})", motion_.worst_step);
    return "  " + closure_sentence(motion_.worst_closure) + step + "\n";
  }

  std::string gaps_text(const char* title, const std::vector<CouplingGap>& gaps) const {
    std::string text;
    for (const CouplingGap& gap : gaps) {
      text += fmt::format("  {} {}: {}, {}\n",
                          title,
                          gap.coupling,
                          amount(gap.distance, motion_.length_unit),
                          amount(gap.angle, motion_.angle_unit));
    }
    return text;
  }

  std::string assembly_text() const {
    std::string text = gaps_text("not assembled at", motion_.drawn_gaps);
    for (const BodyCorrection& one : motion_.corrections) {
      if (one.shift.norm() > 0.0 || one.angle > 0.0) {
        text += fmt::format("  body {} was moved by {} and turned by {} to {}\n",
                            one.body,
                            amount(one.shift.norm(), motion_.length_unit),
                            amount(one.angle, motion_.angle_unit),
                            motion_.nearest_gaps.empty() ? "close it" : "come as near as it can");
      }
    }
    return text + gaps_text("nearest position, apart at", motion_.nearest_gaps);
  }

  static std::string_view title_of(const MotionEvent& event) {
    return event.kind == kDeadPointEvent          ? "dead point of"
           : event.kind == kLimitEvent            ? "limit of"
           : event.kind == kLiftOffEvent          ? "lift-off at"
           : event.kind == kFrictionReversalEvent ? "friction reversal of"
                                                  : "singular position";
  }

  // " ± 7e-11 deg": how uncertain the first drive is, nothing where it is exact.
  std::string bracket_text(const MotionEvent& event) const {
    const std::string& unit = motion_.drives.front().unit;
    return event.uncertainty == 0.0
               ? ""
               : fmt::format(" ± {:.0e}{}{}", event.uncertainty, unit.empty() ? "" : " ", unit);
  }

  std::string when_text(const MotionEvent& event) const {
    if (event.step < 0) {
      return ", on the way to where the motion begins";
    }
    const auto time = is_told_by_time(motion_) ? time_at_row(motion_, event.row) : std::nullopt;
    return fmt::format("{}, after step {}",
                       time ? ", at " + amount(*time, motion_.time_unit) : std::string(),
                       event.step);
  }

  std::string events_text() const {
    std::string text;
    const std::size_t count = std::min(motion_.events.size(), kMostEvents);
    for (std::size_t i = 0; i < count; ++i) {
      const MotionEvent& event = motion_.events[i];
      text +=
          fmt::format("  {}{}{}", title_of(event), event.element.empty() ? "" : " ", event.element);
      for (std::size_t d = 0; d < event.drive.size(); ++d) {
        text += fmt::format("{}{} = {}",
                            d == 0 ? " at " : ", ",
                            motion_.drives[d].name,
                            amount(event.drive[d], motion_.drives[d].unit));
      }
      const std::string jump = jump_text(motion_, event);
      text += bracket_text(event) + when_text(event) + (jump.empty() ? "" : ": " + jump) + "\n";
    }
    if (count < motion_.events.size()) {
      text += fmt::format("  and {} more\n", motion_.events.size() - count);
    }
    return text;
  }

  // The closure error, the last column, is summed up above.
  std::size_t column_count() const { return motion_.columns.size() - 1; }

  // Every k-th row, and the last.
  std::vector<const MotionRow*> shown_rows() const {
    std::vector<const MotionRow*> rows;
    const std::size_t every = (motion_.rows.size() + kMostRows - 2) / (kMostRows - 1);
    for (std::size_t r = 0; r < motion_.rows.size(); ++r) {
      if (r % std::max<std::size_t>(every, 1) == 0 || r + 1 == motion_.rows.size()) {
        rows.push_back(&motion_.rows[r]);
      }
    }
    return rows;
  }

  TextBlocks positions() const {
    if (motion_.rows.empty()) {
      return {};
    }
    const std::vector<const MotionRow*> rows = shown_rows();
    TextBlocks text;
    for (std::size_t first = 1; first == 1 || first < column_count(); first += kMostColumns) {
      text += columns_of(rows, first, std::min(first + kMostColumns, column_count()));
    }
    if (rows.size() < motion_.rows.size()) {
      text += fmt::format("  {} of {} positions; --format csv or json has them all\n\n",
                          rows.size(),
                          motion_.rows.size());
    }
    return text;
  }

  TextBlocks columns_of(const std::vector<const MotionRow*>& rows,
                        std::size_t first,
                        std::size_t last) const {
    std::vector<TextColumn> table = {{"Step", {}}};
    std::vector<std::size_t> chosen = {0};
    for (std::size_t c = first; c < last; ++c) {
      chosen.push_back(c);
    }
    for (const std::size_t c : chosen) {
      const MotionColumn& column = motion_.columns[c];
      const std::string name = c == 0 ? column.element : column.name();
      table.push_back({with_unit(name, column.unit), {}});
    }
    const bool has_status =
        std::ranges::any_of(rows, [](const MotionRow* row) { return row->status != "solved"; });
    if (has_status) {
      table.push_back({"status", {}});
    }
    for (const MotionRow* row : rows) {
      table[0].cells.push_back(std::to_string(row->step));
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        table[i + 1].cells.push_back(shown(row->values[chosen[i]]));
      }
      if (has_status) {
        table.back().cells.push_back(row->status);
      }
    }
    return TextBlocks(std::move(table));
  }

  const MotionTable& motion_;
};

}  // namespace

std::string closure_sentence(double worst) {
  return worst <= kSameValue
             ? fmt::format("every circuit closes to {:.0e} of the mechanism's size or better",
                           kSameValue)
             : fmt::format("circuits close to {:.1e} of the mechanism's size", worst);
}

TextBlocks motion_blocks(const MotionTable& motion) {
  return MotionWriter(motion).run();
}

TextBlocks motion_summary(const MotionTable& motion) {
  return MotionWriter(motion).summary();
}

TextBlocks motion_remarks(const MotionTable& motion) {
  return MotionWriter(motion).remarks();
}

TextBlocks motion_extremes(const MotionTable& motion) {
  return MotionWriter(motion).extremes();
}

std::string jump_text(const MotionTable& motion, const MotionEvent& event) {
  std::string text;
  for (std::size_t c = motion.drives.size(); c < motion.columns.size(); ++c) {
    const MotionColumn& column = motion.columns[c];
    const bool is_of_drive =
        std::ranges::find(motion.drives, column.element, &DriveTravel::name) != motion.drives.end();
    const std::optional<double> before = event.value_before(c);
    const std::optional<double> after = event.value_after(c);
    if (column.quantity == kActionColumn && is_of_drive && (before || after)) {
      text += fmt::format("{}{} {}, then {}{}",
                          text.empty() ? "" : "; ",
                          column.element,
                          shown(before),
                          shown(after),
                          column.unit.empty() ? "" : " " + column.unit);
    }
  }
  return text;
}

}  // namespace kinestat
