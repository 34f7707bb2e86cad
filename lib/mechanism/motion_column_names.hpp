// What the columns of a motion are called that belong to no part of the mechanism.
#pragma once

#include <array>
#include <string_view>

namespace kinestat {

/// The quantity of the column that says how well a position closes.
inline constexpr std::string_view kClosureErrorColumn = "closure_error";

/// The quantity of the column of a motion in time that says when.
inline constexpr std::string_view kTimeColumn = "time";

/// The quantity of the columns that say where the drives stand.
inline constexpr std::string_view kDriveColumn = "drive";

/// Quantities and elements of the columns that `dynamics` stands for and that are of the whole.
inline constexpr std::string_view kKineticEnergyColumn = "kinetic_energy";
inline constexpr std::string_view kKineticEnergyRateColumn = "kinetic_energy_rate";
inline constexpr std::string_view kGroundElement = "ground";
inline constexpr std::string_view kShakingElement = "shaking";

/// Those of `dynamics`.
inline constexpr std::array kColumnsOfDynamics = {
    kKineticEnergyColumn, kKineticEnergyRateColumn, kGroundElement, kShakingElement};

}  // namespace kinestat
