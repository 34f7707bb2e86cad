// The developed section: every axis at its own height, gears in mesh one above the other.
#pragma once

#include "draw/train/scheme_layout.hpp"

namespace kinestat {

/// Of a train with shafts beside the main axis.
SchemeLayout lay_out_developed(const SchemeTrain& train);

}  // namespace kinestat
