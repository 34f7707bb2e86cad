// What `report` of a simulation calls a quantity of all freedoms, actions or of the whole.
#pragma once

#include <array>
#include <string_view>

namespace kinestat {

inline constexpr std::array<std::string_view, 7> kSimulationReportWords = {
    "position", "velocity", "acceleration", "action", "reaction", "power", "energy"};

/// What else it may hold.
inline constexpr std::string_view kSimulationReportNames =
    "the name of a freedom, an actuator, an action, a coupling, a load or a spring, spring.NAME";

/// Before a slash or a point, in names of columns of the whole.
inline constexpr std::string_view kEnergyWord = kSimulationReportWords.back();

}  // namespace kinestat
