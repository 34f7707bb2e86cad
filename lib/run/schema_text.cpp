#include "run/schema_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "report/record_schema.hpp"
#include "run/embedded.hpp"

namespace kinestat {

Outcome schema_text(const std::string& name) {
  Outcome outcome;
  std::vector<std::string> names = names_of(embedded_schemas());
  for (const NamedSchema& schema : record_schemas()) {
    if (schema.name == name) {
      outcome.out = schema.text;
      return outcome;
    }
    names.push_back(schema.name);
  }
  if (const EmbeddedText* schema = find_text(embedded_schemas(), name)) {
    outcome.out = schema->text;
    return outcome;
  }
  std::ranges::sort(names);
  const std::string guess = did_you_mean(name, names);
  add_message("E0101",
              fmt::format("there is no schema '{}'", printable(name)),
              fmt::format("{}{}schemas are {}", guess, guess.empty() ? "" : " ", plain_list(names)),
              outcome);
  return outcome;
}

}  // namespace kinestat
