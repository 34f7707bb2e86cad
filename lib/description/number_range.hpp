// What numbers of a mechanism file may be: the one home of these bounds, for the form of a number
// and for the check of what an expression comes to.
#pragma once

#include <numbers>
#include <optional>

#include "core/digit_limits.hpp"
#include "core/simulation_tolerance.hpp"

namespace kinestat {

/// Of the value in SI.
struct NumberRange {
  std::optional<double> least = {};
  std::optional<double> most = {};
  std::optional<double> above = {};
  std::optional<double> below = {};
  bool is_whole = false;
  bool is_not_zero = false;

  /// Whether a value lies in it; a whole number may be off by rounding.
  bool holds(double value) const;
};

/// What it says of a number in whatever unit: only zero is the same in all of them.
NumberRange in_any_unit(const NumberRange& range);

inline constexpr NumberRange kAnyNumber = {};
inline constexpr NumberRange kAboveZero = {.above = 0};
inline constexpr NumberRange kNotNegative = {.least = 0};
inline constexpr NumberRange kNotNegativeWhole = {.least = 0, .is_whole = true};
inline constexpr NumberRange kNotZero = {.is_not_zero = true};
inline constexpr NumberRange kAtLeastOne = {.least = 1};
inline constexpr NumberRange kLostShare = {.least = 0, .below = 1};
inline constexpr NumberRange kKeptShare = {.most = 1, .above = 0};
inline constexpr NumberRange kAcuteAngle = {.least = 0, .below = std::numbers::pi / 2};
inline constexpr NumberRange kBelowRightAngle = {.above = -std::numbers::pi / 2,
                                                 .below = std::numbers::pi / 2};
inline constexpr NumberRange kTeeth = {.least = 1, .most = 10'000, .is_whole = true};
inline constexpr NumberRange kPlanets = {.least = 1, .most = 64, .is_whole = true};
inline constexpr NumberRange kSteps = {.least = 1, .most = 1'000'000, .is_whole = true};
inline constexpr NumberRange kFluctuation = {.above = 0, .below = 1};
inline constexpr NumberRange kHarmonics = {.least = 1, .most = 100, .is_whole = true};
inline constexpr NumberRange kIntegrationTolerance = {.least = kFinestIntegration,
                                                      .most = kCoarsestIntegration};
inline constexpr NumberRange kPoints = {.least = 2, .most = 1'000'000, .is_whole = true};
inline constexpr NumberRange kSets = {.least = 0, .most = 4, .is_whole = true};
inline constexpr NumberRange kShiftElements = {.least = 0, .most = 7, .is_whole = true};
inline constexpr NumberRange kEngagedElements = {.least = 1, .most = 4, .is_whole = true};
inline constexpr NumberRange kAtMostOne = {.least = 0, .most = 1, .is_whole = true};
inline constexpr NumberRange kForwardGears = {.least = 2, .most = 20, .is_whole = true};
inline constexpr NumberRange kSetTeeth = {.least = 6, .most = 1000, .is_whole = true};
inline constexpr NumberRange kStationaryRatio = {.most = 10, .above = 1};
inline constexpr NumberRange kStates = {.least = 1, .most = 1e12, .is_whole = true};
inline constexpr NumberRange kSeed = {.least = 0, .most = 4'294'967'295, .is_whole = true};
inline constexpr NumberRange kDigits = {
    .least = kLeastDigits, .most = kMostDigits, .is_whole = true};

}  // namespace kinestat
