// What is proved of ranks, as JSON.
#pragma once

#include "report/certainty.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// Of motions and actions; null where nobody asked.
Json certainty_json(const Certainty& certainty);

}  // namespace kinestat
