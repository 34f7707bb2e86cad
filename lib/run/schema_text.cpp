#include "run/schema_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "format/schema.hpp"
#include "report/diagnostic_json.hpp"
#include "report/record_schema.hpp"
#include "studies/compare/compare_text.hpp"
#include "studies/compare/report_kinds.hpp"
#include "studies/sweep/report/sweep_record.hpp"

namespace kinestat {

namespace {

// All JSON that the program writes.
std::vector<ReportKind> written_kinds() {
  std::vector<ReportKind> kinds = {{"comparison", &comparison_record()},
                                   {"diagnostics", &diagnostics_line_record()},
                                   {"sweep", &sweep_summary_record()}};
  kinds.insert(kinds.end(), report_kinds().begin(), report_kinds().end());
  return kinds;
}

}  // namespace

std::vector<std::string> schema_names() {
  std::vector<std::string> names = {"mechanism"};
  for (const ReportKind& kind : written_kinds()) {
    names.emplace_back(kind.name);
  }
  std::ranges::sort(names);
  return names;
}

Outcome schema_text(const std::string& name) {
  Outcome outcome;
  if (name == "mechanism") {
    outcome.out = mechanism_schema();
    return outcome;
  }
  for (const ReportKind& kind : written_kinds()) {
    if (kind.name == name) {
      outcome.out = schema_text_of(kind.name, *kind.record);
      return outcome;
    }
  }
  const std::vector<std::string> names = schema_names();
  const std::string guess = did_you_mean(name, names);
  add_message("E0101",
              fmt::format("there is no schema '{}'", printable(name)),
              fmt::format("{}{}schemas are {}", guess, guess.empty() ? "" : " ", plain_list(names)),
              outcome);
  return outcome;
}

}  // namespace kinestat
