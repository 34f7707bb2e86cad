#include "run/texts/written_reports.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/page_text.hpp"
#include "record/record_table.hpp"
#include "report/diagnostics/diagnostic_json.hpp"
#include "report/file/report_record.hpp"
#include "studies/compare/compare_text.hpp"
#include "studies/sweep/report/sweep_record.hpp"

namespace kinestat {

namespace {

// Keys of the report of an analysis, or of a case in it, by the names of their pages.
constexpr auto kParts = std::to_array<std::string_view>({"mechanism",
                                                         "graph",
                                                         "mobility",
                                                         "kinematics",
                                                         "statics",
                                                         "power",
                                                         "shift",
                                                         "motion",
                                                         "diagnostics"});

struct Part {
  std::string place;  // in the report
  std::string meaning;
  const RecordShape* record = nullptr;
};

// Below the keys of a record.
Part find_part(const RecordShape& above, const std::string& place, std::string_view key) {
  const auto at = std::ranges::find(above.properties, key, &Property::key);
  return at == above.properties.end() ? Part{}
                                      : Part{.place = fmt::format("{}/{}", place, key),
                                             .meaning = at->meaning,
                                             .record = record_behind(at->shape)};
}

Part part_of(std::string_view name) {
  const RecordShape& report = report_record();
  const Part part = find_part(report, "", name);
  return part.record != nullptr
             ? part
             : find_part(*find_part(report, "", "cases").record, "/cases/CASE", name);
}

std::string page_that_tells(const RecordShape& record) {
  const auto at = std::ranges::find_if(
      kParts, [&](std::string_view name) { return part_of(name).record == &record; });
  return at == kParts.end() ? "" : fmt::format("help reports {}", *at);
}

std::string record_page(const std::string& title,
                        const std::string& meaning,
                        const RecordShape& record) {
  return page_lines("", fmt::format("{}: {}", title, meaning), 0) +
         record_table(record, page_that_tells);
}

}  // namespace

std::vector<ReportKind> written_reports() {
  std::vector<ReportKind> kinds = {{"comparison", &comparison_record()},
                                   {"diagnostics", &diagnostics_line_record()},
                                   {"sweep", &sweep_summary_record()}};
  const std::span<const ReportKind> others = report_kinds();
  kinds.insert(kinds.end(), others.begin(), others.end());
  return kinds;
}

std::vector<std::string> report_pages() {
  std::vector<std::string> names(kParts.begin(), kParts.end());
  for (const ReportKind& kind : written_reports()) {
    if (std::ranges::find(names, kind.name) == names.end()) {
      names.emplace_back(kind.name);
    }
  }
  return names;
}

std::string report_page(const std::string& name) {
  std::string text;
  if (std::ranges::find(kParts, name) != kParts.end()) {
    const Part part = part_of(name);
    KINESTAT_EXPECTS(part.record != nullptr);
    text = record_page(part.place, part.meaning, *part.record);
  }
  for (const ReportKind& kind : written_reports()) {
    if (kind.name == name) {
      text += (text.empty() ? "" : "\n") + record_page(name, kind.record->meaning, *kind.record);
    }
  }
  return text;
}

std::string report_keys() {
  return record_table(report_record(), page_that_tells);
}

}  // namespace kinestat
