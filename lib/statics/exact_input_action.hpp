// Actions from the numbers as typed.
#pragma once

#include <optional>

#include "mechanism/bind/exact_input_mechanism.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Does what solve_action does, without rounding and without friction: in fractions if all numbers
/// are fractions, otherwise with a hundred digits. Counts and evidence are copied from `rounded`,
/// the solution in doubles. Actions that are open there stay open, unless the typed numbers leave
/// none open. The status is `inconsistent` if loads balance only by rounding. The result is empty
/// if the primaries are wrong for the typed numbers, if another number of actions is open, or if a
/// number has no digits.
[[nodiscard]] std::optional<StaticSolution> solve_action_of_exact_input(
    const Mechanism& mechanism,
    const std::vector<ExactInputScrew>& actions,
    const Case& which,
    const ExactInputCase& exact_input,
    const StaticSolution& rounded);

}  // namespace kinestat
