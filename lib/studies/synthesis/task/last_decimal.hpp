// How many decimals the positions of a synthesis task are written with.
#pragma once

#include "description/mechanism_description.hpp"
#include "studies/synthesis/positions/position_jets.hpp"

namespace kinestat {

/// Of places and of angles the number with the most decimals: short ones may have lost zeros at
/// their end. Whole numbers, formulas and parameters count as exact. The description is right by
/// itself (check).
LastDecimal last_decimal_of(const MechanismDescription& description);

}  // namespace kinestat
