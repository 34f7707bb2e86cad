// The words that a row of a sweep may have as its status, numbered.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace kinestat {

/// What the case knows suffices with the parameters of the file, and not in this state.
inline constexpr std::string_view kSingular = "singular";

/// The input cannot move, or nothing can.
inline constexpr std::string_view kLocked = "locked";

/// The output rests.
inline constexpr std::string_view kNoRatio = "no_ratio";

/// A position of a motion has no value of a quantity, and nothing else is to blame; or a rate is
/// asked for that no other body feels and nobody gives.
inline constexpr std::string_view kNoNumber = "no_value";

/// All words, "solved" first, the codes of messages last. They do not depend on the sweep, so that
/// pieces of it agree on their numbers without having seen each other.
std::span<const std::string_view> sweep_statuses();

/// The place of a word among them; any other word is a mistake of this program.
std::size_t status_number(std::string_view word);

}  // namespace kinestat
