#include "pages/motion_tables.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/spelling.hpp"
#include "report/number_format.hpp"
#include "studies/motion/report/motion_text.hpp"

namespace kinestat {

namespace {

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : fmt::format("{} [{}]", text, unit);
}

std::string amount(double value, const std::string& unit) {
  return unit.empty() ? format_short(value) : fmt::format("{} {}", format_short(value), unit);
}

// "dead point"
std::string words_of(std::string_view kind) {
  return kind == "singular" ? "singular position" : in_words(kind);
}

}  // namespace

Table drive_table(const MotionTable& motion) {
  Table table({"Drive", "freedom", "from", "to", "reached", "steps"});
  for (const DriveTravel& drive : motion.drives) {
    const double reached = motion.end == MotionEnd::complete ? drive.to : drive.from;
    const bool is_known = motion.end == MotionEnd::complete || drive.reached.has_value();
    table.add({drive.name,
               drive.freedom,
               amount(drive.from, drive.unit),
               amount(drive.to, drive.unit),
               is_known ? amount(drive.reached.value_or(reached), drive.unit) : "-",
               fmt::format("{}", motion.steps)});
  }
  return table;
}

Table event_table(const MotionTable& motion) {
  std::vector<std::string> head = {"Event", "of"};
  for (const DriveTravel& drive : motion.drives) {
    head.push_back(with_unit("at " + drive.name, drive.unit));
  }
  head.emplace_back("after step");
  const bool has_jumps = std::ranges::any_of(
      motion.events, [&](const MotionEvent& one) { return !jump_text(motion, one).empty(); });
  if (has_jumps) {
    head.emplace_back("action of the drive");
  }
  Table table(std::move(head));
  for (const MotionEvent& event : motion.events) {
    std::vector<std::string> cells = {words_of(event.kind), event.element};
    for (std::size_t d = 0; d < motion.drives.size(); ++d) {
      cells.push_back(d < event.drive.size() ? format_short(event.drive[d]) : "-");
    }
    cells.push_back(event.step < 0 ? "-" : fmt::format("{}", event.step));
    if (has_jumps) {
      cells.push_back(jump_text(motion, event));
    }
    table.add(std::move(cells));
  }
  return table;
}

Table position_table(const MotionTable& motion) {
  std::vector<std::string> head = {"Step"};
  for (const MotionColumn& column : motion.columns) {
    head.push_back(with_unit(column.name(), column.unit));
  }
  head.emplace_back("status");
  Table table(std::move(head));
  const std::size_t stride = (motion.rows.size() + kMostPositions - 1) / kMostPositions;
  for (std::size_t i = 0; i < motion.rows.size(); ++i) {
    if (i % stride != 0 && i + 1 != motion.rows.size()) {
      continue;
    }
    const MotionRow& row = motion.rows[i];
    std::vector<std::string> cells = {fmt::format("{}", row.step)};
    for (const std::optional<double>& value : row.values) {
      cells.push_back(value ? format_short(*value) : "-");
    }
    cells.push_back(row.status);
    table.add(std::move(cells));
  }
  return table;
}

}  // namespace kinestat
