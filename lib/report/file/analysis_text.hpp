// The report of one file as tables for people.
#pragma once

#include <string>

#include "cases/analysis.hpp"

namespace kinestat {

/// Title, counts, and for every case the known and the solved magnitudes, six significant digits,
/// with units. Columns that are zero throughout are left out.
std::string analysis_text(const Analysis& analysis);

}  // namespace kinestat
