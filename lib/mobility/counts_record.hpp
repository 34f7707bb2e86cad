// What reports say of freedoms and constraints in the three orders.
#pragma once

#include "mobility/counts.hpp"
#include "record/record.hpp"

namespace kinestat {

/// The three orders side by side.
const Record<MobilityCounts>& counts_record();

}  // namespace kinestat
