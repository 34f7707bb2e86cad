// Diagnostics in the Static Analysis Results Interchange Format, which code hosts and editors show.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "core/exit_status.hpp"
#include "core/source.hpp"

namespace kinestat {

/// What is said of some files, for one log.
struct SarifResults {
  std::vector<std::string> results;  ///< each a JSON object on one line, in the order of the files
  std::vector<std::string_view> codes;  ///< that they have, each once
};

/// Adds what is said of one file; an empty path stands for the program itself, '-' for standard
/// input: their results have no place. Columns count Unicode code points, from 1; what is no
/// printable character in a text stands as \xNN, and in a path as %NN.
void add_results(const SourceFile& source, const Diagnostics& found, SarifResults& results);

/// The log: one JSON document of version 2.1.0 (OASIS 2020), with a line for each result and each
/// rule that a result refers to. ASCII.
std::string sarif_log(const SarifResults& results, ExitStatus status);

}  // namespace kinestat
