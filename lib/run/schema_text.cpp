#include "run/schema_text.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "run/embedded.hpp"

namespace kinestat {

Outcome schema_text(const std::string& name) {
  Outcome outcome;
  if (const EmbeddedText* schema = find_text(embedded_schemas(), name)) {
    outcome.out = schema->text;
    return outcome;
  }
  const std::vector<std::string> names = names_of(embedded_schemas());
  const std::string guess = did_you_mean(name, names);
  add_message("E0101",
              fmt::format("there is no schema '{}'", printable(name)),
              fmt::format("{}{}schemas are {}", guess, guess.empty() ? "" : " ", plain_list(names)),
              outcome);
  return outcome;
}

}  // namespace kinestat
