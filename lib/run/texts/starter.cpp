#include "run/texts/starter.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "run/embedded.hpp"
#include "run/texts/new_file.hpp"

namespace kinestat {

namespace {

void refuse_kind(const std::string& kind, Outcome& outcome) {
  const std::vector<std::string> kinds = starter_kinds();
  add_message("E0101",
              kind.empty() ? "'new' needs a kind of mechanism"
                           : fmt::format("there is no starter file '{}'", printable(kind)),
              guess_before(kind, kinds, "kinds are " + plain_list(kinds, kinds.size())),
              outcome);
}

}  // namespace

std::vector<std::string> starter_kinds() {
  return names_of(embedded_starters());
}

Outcome write_starter(const std::string& kind, const std::string& path, Overwrite overwrite) {
  Outcome outcome;
  const EmbeddedText* starter = find_text(embedded_starters(), kind);
  if (starter == nullptr) {
    refuse_kind(kind, outcome);
  } else {
    give_mechanism_file(std::string(starter->text), path, overwrite, outcome);
  }
  return outcome;
}

}  // namespace kinestat
