// The states of a transmission as JSON.
#pragma once

#include "report/analysis.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// The value of the key `shift` in a report; the analysis must have that section.
Json shift_json(const Analysis& analysis);

}  // namespace kinestat
