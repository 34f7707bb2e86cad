// The status of a row: whether one case has an answer in one state or position, and why not.
#pragma once

#include <array>
#include <string_view>

#include "cases/analysis.hpp"

namespace kinestat {

inline constexpr std::string_view kAmbiguous = "ambiguous";
inline constexpr std::string_view kCableSlack = "cable_slack";
inline constexpr std::string_view kContactPulls = "contact_pulls";
inline constexpr std::string_view kCableSlips = "cable_slips";
inline constexpr std::string_view kFreewheelOverruns = "freewheel_overruns";
inline constexpr std::string_view kFreewheelLocks = "freewheel_locks";
inline constexpr std::string_view kUnbalanced = "unbalanced";
inline constexpr std::string_view kSelfLocking = "self_locking";
inline constexpr std::string_view kUnknownLoad = "unknown_load";

/// Of a solved case whose efficiency is asked for, and has none for a reason.
inline constexpr std::string_view kNoEfficiency = "no_efficiency";

/// The words that impossible_status may give.
inline constexpr std::array kImpossibleStatuses = {
    kCableSlack, kContactPulls, kCableSlips, kFreewheelOverruns, kFreewheelLocks};

/// The words that case_status may give besides those of SolveStatus.
inline constexpr std::array kCaseStatuses = {kAmbiguous,
                                             kCableSlack,
                                             kContactPulls,
                                             kCableSlips,
                                             kFreewheelOverruns,
                                             kFreewheelLocks,
                                             kUnbalanced,
                                             kSelfLocking,
                                             kUnknownLoad};

/// Why the mechanism cannot have the answer: "cable_slack" if a cable would have to push,
/// "contact_pulls" if surfaces would have to pull on each other, "cable_slips" if a cable would
/// need more friction than there is, "freewheel_overruns" if a freewheel would have to hold the
/// other torque, "freewheel_locks" if it would have to slip the other way. Otherwise empty.
std::string_view impossible_status(const Mechanism& mechanism, const CaseAnalysis& one);

/// The status of a case: that of the motion or of the actions if they have no answer, or why the
/// answer is impossible; then what is wrong with the power, if that or the efficiency is asked for,
/// and that there is no efficiency, if that is; otherwise "solved".
std::string_view case_status(const Mechanism& mechanism,
                             const CaseAnalysis& one,
                             bool asks_power,
                             bool asks_efficiency = false);

}  // namespace kinestat
