// Velocities from the numbers as typed.
#pragma once

#include <optional>
#include <span>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/bind/exact_input_mechanism.hpp"

namespace kinestat {

/// solve_velocity without rounding: in fractions where all numbers are, otherwise in a hundred
/// digits. Counts, evidence and the check of the primaries are those of `rounded`, the solution in
/// doubles. Empty where the primaries are not right as typed, or a number has no digits.
[[nodiscard]] std::optional<KinematicSolution> solve_velocity_of_exact_input(
    const Mechanism& mechanism,
    const std::vector<ExactInputScrew>& motions,
    std::span<const Primary> primaries,
    std::span<const ExactInput> values,
    const KinematicSolution& rounded);

}  // namespace kinestat
