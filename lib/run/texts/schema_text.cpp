#include "run/texts/schema_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "format/schema.hpp"
#include "report/record_schema.hpp"
#include "run/texts/written_reports.hpp"

namespace kinestat {

std::vector<std::string> schema_names() {
  std::vector<std::string> names = {"mechanism"};
  for (const ReportKind& kind : written_reports()) {
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
  for (const ReportKind& kind : written_reports()) {
    if (kind.name == name) {
      outcome.out = schema_text_of(kind.name, *kind.record);
      return outcome;
    }
  }
  const std::vector<std::string> names = schema_names();
  add_message("E0101",
              fmt::format("there is no schema '{}'", printable(name)),
              guess_before(name, names, "schemas are " + plain_list(names)),
              outcome);
  return outcome;
}

}  // namespace kinestat
