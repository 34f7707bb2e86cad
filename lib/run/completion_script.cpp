#include "run/completion_script.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "run/embedded.hpp"

namespace kinestat {

Outcome completion_script(const std::string& shell) {
  Outcome outcome;
  if (const EmbeddedText* script = find_text(embedded_completions(), shell)) {
    outcome.out = script->text;
    return outcome;
  }
  add_message("E0101",
              fmt::format("there is no completion for '{}'", printable(shell)),
              fmt::format("shells are {}", plain_list(names_of(embedded_completions()))),
              outcome);
  return outcome;
}

}  // namespace kinestat
