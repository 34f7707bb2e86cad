#include "studies/tolerance/report/tolerance_report.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/page_text.hpp"
#include "core/text.hpp"
#include "expression/unit_quotient.hpp"
#include "report/in_units.hpp"
#include "report/number_format.hpp"
#include "report/report_parts.hpp"
#include "report/table.hpp"
#include "report/text_blocks.hpp"
#include "studies/tolerance/report/tolerance_record.hpp"

namespace kinestat {

namespace {

std::string with_unit(double si, QuantityKind kind, const FileUnits& units) {
  return format_short(InUnits(units).of(kind, si)) + " " + units.text(kind);
}

// What moves most first, as far as the table shows; the same order where nothing says how much.
std::vector<ToleranceShare> by_size(std::vector<ToleranceShare> shares, bool has_tolerances) {
  if (has_tolerances) {
    std::ranges::stable_sort(shares, std::greater(), [](const ToleranceShare& share) {
      return std::stod(format_short(share.moved));
    });
  }
  return shares;
}

std::string direction_text(const std::optional<Vec3>& direction, Space space) {
  if (!direction) {
    return "-";
  }
  std::vector<std::string> parts;
  const int count = space == Space::planar ? 2 : 3;
  for (int i = 0; i < count; ++i) {
    parts.push_back(format_short((*direction)[i]));
  }
  return fmt::format("{}", fmt::join(parts, " "));
}

Table table_of(const ToleranceStack& stack,
               const MechanismDescription& description,
               bool has_tolerances) {
  const FileUnits& units = description.units;
  const QuantityKind of = stack.position.kind;
  std::vector<std::string> head = {"by", "influence", "unit", "direction"};
  if (has_tolerances) {
    head.insert(head.end(), {"tolerance", fmt::format("moved [{}]", units.text(of))});
  }
  Table table(head);
  for (const ToleranceShare& share : by_size(stack.shares, has_tolerances)) {
    const ShownValue influence = shown_influence(share, of, units);
    const bool turns_in_plane =
        description.space == Space::planar && share.kind == QuantityKind::angle;
    std::vector<std::string> row = {
        share.name,
        format_short(influence.value),
        influence.unit,
        turns_in_plane ? "-" : direction_text(share.direction, description.space)};
    if (has_tolerances) {
      row.push_back(share.tolerance == 0.0 ? "exact"
                                           : "±" + with_unit(share.tolerance, share.kind, units));
      row.push_back(format_short(InUnits(units).of(of, share.moved)));
    }
    table.add(row);
  }
  return table;
}

std::string worst_text(const ToleranceStack& stack, const FileUnits& units) {
  return fmt::format("worst case ±{}, root sum square ±{}",
                     with_unit(stack.worst_case, stack.position.kind, units),
                     with_unit(stack.root_sum_square, stack.position.kind, units));
}

std::string held_text(const std::vector<std::string>& held) {
  return held.empty() ? "nothing" : plain_list(held);
}

TextBlocks loose_text(const std::vector<std::string>& positions) {
  return TextBlocks(positions.empty()
                        ? std::string()
                        : page_lines("  ",
                                     fmt::format("The drives do not hold {}: an idle freedom moves "
                                                 "{}.",
                                                 plain_list(positions),
                                                 positions.size() == 1 ? "it" : "them"),
                                     2) +
                              "\n");
}

TextBlocks not_fitting_text(const std::vector<std::string>& actions) {
  return TextBlocks(actions.empty()
                        ? std::string()
                        : page_lines("  ",
                                     fmt::format("No part can deviate alone along or about {}: "
                                                 "redundant constraints bear them, and others "
                                                 "would bend, or need play.",
                                                 plain_list(actions)),
                                     2) +
                              "\n");
}

TextBlocks case_text(const CaseTolerance& one, const MechanismDescription& description) {
  TextBlocks text(fmt::format("Case {}: {} held where drawn\n", one.label, held_text(one.held)));
  for (const ToleranceStack& stack : one.positions) {
    text += fmt::format("  {}{}\n",
                        stack.position.name,
                        one.has_tolerances ? ": " + worst_text(stack, description.units) : "");
    text += TextBlocks(table_of(stack, description, one.has_tolerances), "    ");
    text += "\n";
  }
  text += loose_text(one.loose);
  text += not_fitting_text(one.not_fitting);
  return text;
}

// The steps in which a position is known.
std::vector<const CaseTolerance*> steps_with(const std::vector<CaseTolerance>& steps,
                                             std::size_t position) {
  std::vector<const CaseTolerance*> result;
  for (const CaseTolerance& one : steps) {
    if (position < one.positions.size()) {
      result.push_back(&one);
    }
  }
  return result;
}

std::string place_text(const DrivePlace& drive) {
  return fmt::format("{} = {} {}", drive.name, format_short(drive.value.value), drive.value.unit);
}

// Of each position where it is off most, and where least.
TextBlocks motion_text(const std::vector<CaseTolerance>& steps,
                       const MechanismDescription& description) {
  const FileUnits& units = description.units;
  const auto whole = std::ranges::max_element(
      steps, {}, [](const CaseTolerance& one) { return one.positions.size(); });
  if (whole == steps.end()) {
    return {};
  }
  const auto singular =
      std::ranges::count_if(steps, [](const CaseTolerance& one) { return one.held.empty(); });
  TextBlocks text(fmt::format("{} step{} from {} to {}, {} held in each\n",
                              steps.size() - 1,
                              steps.size() == 2 ? "" : "s",
                              place_text(*steps.front().drive),
                              place_text(*steps.back().drive),
                              held_text(whole->held)));
  if (singular > 0) {
    text += fmt::format("  {} of them {} in a singular position, where nothing is held\n",
                        singular,
                        singular == 1 ? "is" : "are");
  }
  for (std::size_t w = 0; w < whole->positions.size(); ++w) {
    const std::vector<const CaseTolerance*> known = steps_with(steps, w);
    const auto [least, most] = std::ranges::minmax_element(
        known, {}, [&](const CaseTolerance* one) { return one->positions[w].worst_case; });
    const ToleranceStack& stack = (*most)->positions[w];
    text += fmt::format("  {}\n", stack.position.name);
    if (whole->has_tolerances) {
      text += fmt::format("    most at {}: {}\n    least at {}: {}\n",
                          place_text(*(*most)->drive),
                          worst_text(stack, units),
                          place_text(*(*least)->drive),
                          worst_text((*least)->positions[w], units));
    }
    text += TextBlocks(table_of(stack, description, whole->has_tolerances), "    ");
    text += "\n";
  }
  text += loose_text(whole->loose);
  text += not_fitting_text(whole->not_fitting);
  return text;
}

}  // namespace

ShownValue shown_influence(const ToleranceShare& share,
                           QuantityKind position,
                           const FileUnits& units) {
  return {.value = share.influence * units.factor(share.kind) / units.factor(position),
          .unit = share.kind == position
                      ? ""
                      : unit_quotient(units.text(position), units.text(share.kind))};
}

FileReport make_tolerance_report(const std::string& file,
                                 const MechanismDescription& description,
                                 const FoundTolerance& answer,
                                 const ReportForms& forms,
                                 const Diagnostics& found) {
  FileReport report;
  const ToleranceReportView view{
      .file = file, .description = description, .answer = answer, .found = &found};
  add_json(tolerance_report_record, view, description.units, forms, report);
  if (forms.csv) {
    report.csv = tables_of(tolerance_report_record(),
                           view,
                           name_in_tables(file, description),
                           description.units,
                           MissingNumber::empty_cell,
                           "by");
  }
  if (forms.text) {
    report.text = TextBlocks((description.name.empty() ? file : description.name) + "\n\n");
    if (answer.is_along) {
      report.text += motion_text(answer.cases, description);
    }
    for (const CaseTolerance& one : answer.is_along ? std::vector<CaseTolerance>() : answer.cases) {
      report.text += case_text(one, description);
    }
  }
  return report;
}

}  // namespace kinestat
