#include "studies/motion/task/position_findings.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/case_efficiency.hpp"
#include "cases/case_status.hpp"
#include "core/text.hpp"
#include "core/tolerance.hpp"
#include "report/number_format.hpp"
#include "studies/motion/report/motion_time.hpp"

namespace kinestat {

namespace {

// Messages name so many brackets; the statuses of the rows have them all.
constexpr std::size_t kMostBrackets = 3;

bool says_the_same(const CaseFinding& one, const CaseFinding& other) {
  return one.code == other.code && one.where == other.where && one.element == other.element;
}

// Of the drawn position, by a whole analysis.
bool is_said(const CaseFinding& one,
             const std::string& label,
             std::span<const Diagnostic> of_drawing) {
  const std::string beginning = fmt::format("case '{}'", label);
  return std::ranges::any_of(of_drawing, [&](const Diagnostic& other) {
    return other.code == one.code && other.where == one.where &&
           other.message.starts_with(beginning) == one.message.starts_with(beginning) &&
           other.message.find(one.element) != std::string::npos;
  });
}

}  // namespace

void PositionFindings::add(const FoundPlace& where, const CaseFindings& found) {
  const bool is_kept =
      where.row && (kept_.empty() || std::ranges::binary_search(kept_, *where.row));
  const Place place{
      .count = count_++, .drive = where.drive, .time = where.time, .is_kept = is_kept};
  for (const CaseFinding& one : found.items()) {
    const auto same = std::ranges::find_if(
        held_, [&](const Held& held) { return says_the_same(held.worst, one); });
    if (same == held_.end()) {
      held_.push_back({.worst = one, .worst_at = place, .places = {place}});
      continue;
    }
    if (same->places.back().count != place.count) {
      same->places.push_back(place);
    }
    same->varies = same->varies || one.size < same->worst.size * (1.0 - kSameValue);
    if (one.size > same->worst.size * (1.0 + kSameValue)) {
      same->varies = true;
      same->worst = one;
      same->worst_at = place;
    }
  }
}

bool PositionFindings::has_errors() const {
  return std::ranges::any_of(held_,
                             [](const Held& one) { return one.worst.severity == Severity::error; });
}

// Of the first drive, or in time where it dwells or comes back; without a unit.
std::string PositionFindings::text_of(const Place& place, const MotionTable& table) {
  return format_short(is_told_by_time(table) ? place.time.value_or(0.0) : place.drive);
}

// "M from 40 to 60 deg, 3 of 7 positions"
std::string PositionFindings::brackets_text(std::span<const Place> places,
                                            const MotionTable& table) {
  const bool is_in_time = is_told_by_time(table);
  const DriveTravel& drive = table.drives.front();
  const std::string& unit = is_in_time ? table.time_unit : drive.unit;
  std::vector<std::string> brackets;
  for (std::size_t first = 0; first < places.size();) {
    std::size_t last = first;
    while (last + 1 < places.size() && places[last + 1].count == places[last].count + 1) {
      ++last;
    }
    const std::string from = text_of(places[first], table);
    const std::string to = text_of(places[last], table);
    brackets.push_back(from == to ? "at " + from : fmt::format("from {} to {}", from, to));
    first = last + 1;
  }
  const std::size_t more = brackets.size() - std::min(brackets.size(), kMostBrackets);
  brackets.resize(brackets.size() - more);
  const auto kept = std::ranges::count(places, true, &Place::is_kept);
  return fmt::format(
      "{}{}{}{}{}, {}",
      is_in_time ? std::string() : drive.name + " ",
      fmt::join(brackets, ", "),
      unit.empty() ? "" : " ",
      unit,
      more == 0 ? std::string() : " and " + counted(more, "more range"),
      kept == 0 ? "between the steps" : fmt::format("{} of {} positions", kept, table.rows.size()));
}

void PositionFindings::tell(const MotionTable& table, Diagnostics& found) const {
  const std::size_t said = found.items().size();
  for (const Held& held : held_) {
    // A dimension that friction lacks, W0604, it lacks everywhere.
    const bool is_everywhere = held.places.size() == count_ || held.worst.code == "W0604";
    if (is_everywhere && is_said(held.worst, table.label, found.items().first(said))) {
      continue;
    }
    CaseFinding one = held.worst;
    one.message += fmt::format(
        " ({}{})",
        brackets_text(held.places, table),
        held.varies ? ", the worst at " + text_of(held.worst_at, table) : std::string());
    kinestat::add(one, found);
  }
}

CaseFindings judge_position(const MechanismDescription& description,
                            const MotionPlan& plan,
                            const MotionPosition& position,
                            const Mechanism& moved,
                            const CaseFindings* before) {
  if (!position.solved) {
    return CaseFindings();
  }
  const std::optional<ShiftAnalysis> no_shift;
  const JudgedFile file = {.description = description, .mechanism = moved, .shift = no_shift};
  const auto is_reported = [before](std::string_view code, SourceRange where) {
    return before != nullptr && std::ranges::any_of(before->items(), [&](const CaseFinding& one) {
             return one.code == code && one.where == where;
           });
  };
  CaseFindings said = find_case_findings(file, *position.solved, is_reported);
  if (plan.report.efficiency) {
    add_efficiency_findings(moved, *position.solved, said);
  }
  return said;
}

std::string status_of_position(const MotionPlan& plan,
                               const MotionPosition& position,
                               const Mechanism& moved) {
  if (position.state.is_singular) {
    return std::string(kSingularEvent);
  }
  return position.solved
             ? std::string(case_status(
                   moved, *position.solved, plan.report.has_powers(), plan.report.efficiency))
             : "solved";
}

void add_efficiency_findings(const Mechanism& mechanism,
                             const CaseAnalysis& one,
                             CaseFindings& found) {
  const Efficiency efficiency = case_efficiency(one, mechanism);
  if (!one.power || efficiency.value || efficiency.is_self_locking) {
    return;
  }
  const bool is_lossless = !loses_power(one);
  const std::string reason = is_lossless ? "nothing loses power" : efficiency.reason;
  found
      .warning("W0516",
               one.which.where,
               fmt::format("case '{}' has no efficiency: {}", one.which.label, reason),
               is_lossless ? "give couplings 'friction', or meshes 'losses'; or take 'efficiency' "
                             "out of 'report'"
                           : "'report: power' shows where power goes there; name as 'input' what "
                             "supplies it and as 'output' what takes it")
      .element = reason;
}

namespace {

std::string place_of_drives(const MotionTable& table, const std::vector<double>& drives) {
  std::string text;
  for (std::size_t d = 0; d < drives.size(); ++d) {
    const DriveTravel& drive = table.drives[d];
    text += fmt::format("{}{} = {}{}{}",
                        d == 0 ? "" : ", ",
                        drive.name,
                        format_short(drives[d]),
                        drive.unit.empty() ? "" : " ",
                        drive.unit);
  }
  return text;
}

std::string place_in_time(const MotionTable& table, double time) {
  return fmt::format("{} = {} {}", kTimeColumn, format_short(time), table.time_unit);
}

}  // namespace

std::string row_place(const MotionTable& table, const MotionRow& row) {
  if (is_told_by_time(table)) {
    return place_in_time(table, row.values[*time_column(table)].value_or(0.0));
  }
  std::vector<double> drives;
  for (std::size_t d = 0; d < table.drives.size(); ++d) {
    drives.push_back(row.values[d].value_or(0.0));
  }
  return place_of_drives(table, drives);
}

std::string event_place(const MotionTable& table, const MotionEvent& event) {
  const auto time = is_told_by_time(table) ? time_at_row(table, event.row) : std::nullopt;
  return time ? place_in_time(table, *time) : place_of_drives(table, event.drive);
}

}  // namespace kinestat
