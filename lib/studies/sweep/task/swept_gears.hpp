// The combinations of the section `shift` that a sweep runs: what they are is decided in every
// state anew.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "description/mechanism_description.hpp"
#include "mechanism/mechanism.hpp"
#include "mechanism/shift_plan.hpp"
#include "studies/shift/shift_solution.hpp"
#include "studies/sweep/report/sweep_rows.hpp"

namespace kinestat {

/// A combination, with the parameters of the file.
struct SweptGear {
  NamedShiftState state;
  GearCase described;  ///< how the case of its name was described
};

/// The combination that a label of `sweep: cases` names: that of a label of `shift`, or elements
/// joined with '+'. Empty if it names none. Its case has this name.
std::optional<NamedShiftState> find_combination(std::string_view label,
                                                const Mechanism& mechanism,
                                                const ShiftPlan& plan);

/// Of each case the state of its combination in a mechanism; of cases that are no combinations,
/// empty. `plan` must be bound with the parameters of the mechanism where freewheels are to be
/// judged.
std::vector<std::optional<ShiftState>> find_states(
    const std::vector<std::optional<SweptGear>>& gears,
    const Mechanism& mechanism,
    const ShiftPlan& plan);

/// The case of a gear where it is not as the file's own parameters have it: then an input or an
/// element follows from others that did not. Empty where it is.
std::optional<Case> described_anew(const SweptGear& gear,
                                   const ShiftState& state,
                                   const ShiftPlan& plan,
                                   const MechanismDescription& description,
                                   const Mechanism& mechanism);

/// Fills the columns `step`, the ratio of the next lower gear over a gear's own: of the gears of
/// one state, whose ratios are given for each row, empty for what is no gear. `forward` is the sign
/// of the ratios of forward gears.
void fill_steps(std::span<const SweepColumn> columns,
                double forward,
                std::span<const std::optional<double>> ratios,
                std::span<SweepRow> rows);

}  // namespace kinestat
