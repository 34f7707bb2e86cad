// The names of those columns of a motion that belong to no part of the mechanism.
#pragma once

#include <array>
#include <string_view>

namespace kinestat {

/// The quantity of the column with the closure error of a position.
inline constexpr std::string_view kClosureErrorColumn = "closure_error";

/// The quantity of the column with the time, in a motion in time.
inline constexpr std::string_view kTimeColumn = "time";

/// The quantity of the columns with the positions of the drives.
inline constexpr std::string_view kDriveColumn = "drive";

/// The quantity of the columns of actions, whose elements are actions and actuators.
inline constexpr std::string_view kActionColumn = "action";

/// The quantity of the column with the efficiency of the case.
inline constexpr std::string_view kEfficiencyColumn = "efficiency";

/// Quantities and elements of the columns of `dynamics` that belong to the whole mechanism.
inline constexpr std::string_view kKineticEnergyColumn = "kinetic_energy";
inline constexpr std::string_view kKineticEnergyRateColumn = "kinetic_energy_rate";
inline constexpr std::string_view kGroundElement = "ground";
inline constexpr std::string_view kShakingElement = "shaking";

/// All of the columns of `dynamics` that belong to the whole mechanism.
inline constexpr std::array kColumnsOfDynamics = {
    kKineticEnergyColumn, kKineticEnergyRateColumn, kGroundElement, kShakingElement};

}  // namespace kinestat
