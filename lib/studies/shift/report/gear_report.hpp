// What a report says of one gear beside its case.
#pragma once

#include <vector>

#include "cases/analysis.hpp"
#include "cases/report/ratio_in_units.hpp"
#include "studies/shift/gear_values.hpp"

namespace kinestat {

/// The case of a state; null for one that is no gear.
const CaseAnalysis* find_gear_case(const Analysis& analysis, const NamedShiftState& state);

/// Of the state with this index, which must be a gear.
GearValues gear_values(const Analysis& analysis, std::size_t state);

/// Of each body what it adds to the equivalent inertia at the input of a gear [kg·m²]; empty with
/// several inputs or one that slides, and where no body has mass or inertia.
std::optional<std::vector<double>> gear_inertias(const Analysis& analysis,
                                                 const CaseAnalysis& gear);

/// Its ratios to each output in the units of the file.
std::vector<RatiosInUnits> gear_ratios(const Analysis& analysis,
                                       std::size_t state,
                                       const GearValues& gear);

/// What the speed of an output has of that of each input, where several may have a speed of their
/// own; empty elsewhere. In the rate unit of the output per that of the input.
std::vector<RatioInUnits> speed_shares(const Analysis& analysis,
                                       const ShiftState& state,
                                       std::size_t output);

/// The units of these ratios, which are those of every gear, without values.
std::vector<RatiosInUnits> gear_ratio_units(const Analysis& analysis);

}  // namespace kinestat
