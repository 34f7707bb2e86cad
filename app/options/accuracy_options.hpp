// The options by which the user trades time for accuracy.
#pragma once

#include "options/file_options.hpp"

namespace kinestat::app {

/// Declares --accuracy and --digits.
void add_accuracy(CLI::App& command, AccuracyRequest& request);

}  // namespace kinestat::app
