// Points of a curve from a table beside the mechanism file.
#pragma once

#include <string>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "io/read_file.hpp"

namespace kinestat {

/// `text` is NAME=FILE. The file has two columns, places and values, under a head line that has
/// their units in brackets; without one a column has bare numbers.
void apply_curve_table(const std::string& text,
                       const ReadLimits& limits,
                       MechanismDescription& description,
                       Diagnostics& found);

}  // namespace kinestat
