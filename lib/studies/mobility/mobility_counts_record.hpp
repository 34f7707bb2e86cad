// What reports say of freedoms and constraints in the three orders.
#pragma once

#include "record/record.hpp"
#include "studies/mobility/mobility_counts.hpp"

namespace kinestat {

/// The three orders side by side.
const Record<MobilityCounts>& counts_record();

}  // namespace kinestat
