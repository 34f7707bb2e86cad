// The degrees of freedom and of constraint as JSON.
#pragma once

#include "mobility/counts.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// The minimal, planar and spatial order side by side, and the evidence of the rank.
Json mobility_counts_json(const MobilityCounts& counts);

}  // namespace kinestat
