// What a report says of errors and warnings.
#pragma once

#include "core/diagnostic.hpp"
#include "record/record.hpp"

namespace kinestat {

/// Writes the diagnostics as a list.
void write_diagnostics(const Diagnostics& found, Archive& to);
Shape diagnostics_shape();

}  // namespace kinestat
