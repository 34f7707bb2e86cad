// The status of a row: what became of one case in one state or position.
#pragma once

#include <array>
#include <string_view>

#include "cases/analysis.hpp"

namespace kinestat {

inline constexpr std::string_view kAmbiguous = "ambiguous";
inline constexpr std::string_view kCableSlack = "cable_slack";
inline constexpr std::string_view kContactPulls = "contact_pulls";
inline constexpr std::string_view kCableSlips = "cable_slips";
inline constexpr std::string_view kUnbalanced = "unbalanced";
inline constexpr std::string_view kSelfLocking = "self_locking";
inline constexpr std::string_view kUnknownLoad = "unknown_load";

/// What case_status may say beside the words of SolveStatus.
inline constexpr std::array kCaseStatuses = {
    kAmbiguous, kCableSlack, kContactPulls, kCableSlips, kUnbalanced, kSelfLocking, kUnknownLoad};

/// Whether the answer is one that the mechanism can have: "cable_slack", "contact_pulls" or
/// "cable_slips" where a cable would have to push, surfaces to pull on each other or a cable to
/// hold by more friction than there is; otherwise empty.
std::string_view impossible_status(const Mechanism& mechanism, const CaseAnalysis& one);

/// The status of the motion or of the actions where they have no answer, or an impossible one; then
/// what else is wrong with the power, if that is asked for; "solved" where nothing is.
std::string_view case_status(const Mechanism& mechanism, const CaseAnalysis& one, bool asks_power);

}  // namespace kinestat
