#include "run/texts/starter.hpp"

#include <array>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "run/embedded.hpp"

namespace kinestat {

namespace {

void refuse_kind(const std::string& kind, Outcome& outcome) {
  const std::vector<std::string> kinds = starter_kinds();
  add_message("E0101",
              kind.empty() ? "'new' needs a kind of mechanism"
                           : fmt::format("there is no starter file '{}'", printable(kind)),
              guess_before(kind, kinds, "kinds are " + plain_list(kinds)),
              outcome);
}

void write(const EmbeddedText& starter,
           const std::string& path,
           Overwrite overwrite,
           Outcome& outcome) {
  // Without a signature no present file is taken for one of this program's own.
  const std::array<OutputFile, 1> files = {
      {{.path = path, .content = std::string(starter.text), .signature = {}}}};
  Diagnostics found;
  if (write_files(files, overwrite, found)) {
    const std::string_view command = starter.name == "synthesis" ? "synthesize" : "analyze";
    outcome.out = fmt::format("{0}: written; see 'kinestat {1} {0}'\n", printable(path), command);
    return;
  }
  if (found.items().front().code == "E0153") {
    add_message("E0153",
                fmt::format("'{}' exists and is left as it is", printable(path)),
                "choose another name, or give --force to replace it",
                outcome);
    return;
  }
  add_diagnostics({}, found, Strictness::normal, outcome);
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
  } else if (path.empty()) {
    outcome.out = starter->text;
  } else {
    write(*starter, path, overwrite, outcome);
  }
  return outcome;
}

}  // namespace kinestat
