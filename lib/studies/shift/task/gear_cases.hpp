// The gears of the section `shift` as cases of the mechanism.
#pragma once

#include <optional>
#include <vector>

#include "cases/analysis.hpp"
#include "core/diagnostic.hpp"

namespace kinestat {

/// What the case of a gear knows: a freedom of the train that the engaged elements do not hold is
/// an input's, and of torques that follow from others none is given.
GearCase gear_case(const NamedShiftState& state, const ShiftPlan& plan);

/// Adds them to the cases of the mechanism that was bound, and as descriptions to those of the
/// file: so whatever binds the cases anew finds them.
void add_gear_cases(const std::vector<GearCase>& gears,
                    const ShiftPlan& plan,
                    MechanismDescription& description,
                    Mechanism& mechanism);

/// Finds all states of a mechanism that has been bound, and adds every gear to the cases of the
/// description and of the mechanism. Empty if there is no section `shift`, or with an error if it
/// has more combinations than a table can have, or a limit of a planet that is none.
std::optional<ShiftAnalysis> add_gears(MechanismDescription& description,
                                       Mechanism& mechanism,
                                       const ShiftOptions& options,
                                       Diagnostics& found);

}  // namespace kinestat
