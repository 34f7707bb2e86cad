// What reports say of the gears of a transmission.
#pragma once

#include "cases/analysis.hpp"
#include "record/record.hpp"

namespace kinestat {

/// Of an analysis with a section 'shift'.
const Record<Analysis>& shift_record();

}  // namespace kinestat
