// Velocities from the numbers as typed.
#pragma once

#include <optional>
#include <span>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/bind/exact_input_mechanism.hpp"

namespace kinestat {

/// Does what solve_velocity does, without rounding: in fractions if all numbers are fractions,
/// otherwise with a hundred digits. Counts, evidence and the check of the primaries are copied from
/// `rounded`, the solution in doubles. `values` are those of the primaries. Empty if the primaries
/// are wrong for the typed numbers, or if a number has no digits.
[[nodiscard]] std::optional<KinematicSolution> solve_velocity_of_exact_input(
    const Mechanism& mechanism,
    const std::vector<ExactInputScrew>& motions,
    std::span<const Primary> primaries,
    std::span<const ExactInput> values,
    const KinematicSolution& rounded);

}  // namespace kinestat
