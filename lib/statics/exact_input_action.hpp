// Actions from the numbers as typed.
#pragma once

#include <optional>

#include "mechanism/bind/exact_input_mechanism.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// solve_action without rounding and without friction: in fractions where all numbers are,
/// otherwise in a hundred digits. Counts and evidence are those of `rounded`, the solution in
/// doubles. Actions that it leaves open stay so, unless none is open as typed. Inconsistent where
/// loads that balance but for rounding do not as typed. Empty where the primaries are not right as
/// typed, as many actions are not open, or a number has no digits.
[[nodiscard]] std::optional<StaticSolution> solve_action_of_exact_input(
    const Mechanism& mechanism,
    const std::vector<ExactInputScrew>& actions,
    const Case& which,
    const ExactInputCase& exact_input,
    const StaticSolution& rounded);

}  // namespace kinestat
