// The options by which reports are written as files.
#pragma once

#include <string>

#include "options/file_options.hpp"

namespace kinestat::app {

/// Declares -o, explained by this, and --force.
void add_output(CLI::App& command, AnalyseOptions& analyse, const std::string& explanation);

}  // namespace kinestat::app
