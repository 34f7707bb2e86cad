#include "run/texts/new_file.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/utf8.hpp"

namespace kinestat {

namespace {

bool has_section(std::string_view text, std::string_view name) {
  return text.find(fmt::format("\n{}:", name)) != std::string_view::npos;
}

std::string_view command_for(std::string_view text) {
  if (!has_section(text, "couplings")) {
    return "synthesize";
  }
  if (has_section(text, "simulation") && !has_section(text, "cases")) {
    return "simulate";
  }
  return has_section(text, "sweep") ? "sweep" : "analyze";
}

}  // namespace

void give_mechanism_file(std::string text,
                         const std::string& path,
                         Overwrite overwrite,
                         Outcome& outcome) {
  if (path.empty()) {
    outcome.out = std::move(text);
    return;
  }
  const std::string_view command = command_for(text);
  // Without a signature no present file is taken for one of this program's own.
  const std::array<OutputFile, 1> files = {
      {{.path = path, .content = std::move(text), .signature = {}}}};
  Diagnostics found;
  if (write_files(files, overwrite, {}, found)) {
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

}  // namespace kinestat
