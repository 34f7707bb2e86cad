// The words of the command line.
#pragma once

#include <string>
#include <vector>

#include "files/outcome.hpp"

namespace kinestat::app {

/// The words as they can be parsed. Those after `--` are no options, however they begin: each gets
/// a NUL in front, which no word of a command line has, and the mark goes. `--out=` becomes `--out`
/// and an empty word, or the parser would take the next one for the value.
std::vector<std::string> plain_words(int argc, char** argv);

/// The word as the user wrote it.
std::string as_written(const std::string& word);

/// What `--diagnostics` among the words asks for, be the rest right or wrong.
DiagnosticsForm diagnostics_form(const std::vector<std::string>& words);

}  // namespace kinestat::app
