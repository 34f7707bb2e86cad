// The gears of the section `shift` as cases of the mechanism.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "report/analysis.hpp"

namespace kinestat {

/// Finds all states of a mechanism that has been bound, and adds every gear to the cases of the
/// description and of the mechanism. Empty if there is no section `shift`, or with an error if it
/// has more combinations than a table can have.
std::optional<ShiftAnalysis> add_gears(MechanismDescription& description,
                                       Mechanism& mechanism,
                                       const ShiftOptions& options,
                                       Diagnostics& found);

}  // namespace kinestat
