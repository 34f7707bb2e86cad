// The styles of text that several pictures share, and how wide these letters let a picture be.
#pragma once

#include "draw/svg.hpp"

namespace kinestat {

inline constexpr double kTextSize = 12.0;  ///< of what a picture names [px]
inline constexpr TextStyle kSmall = {.ink = Ink::soft, .size = 11.0};  ///< of remarks and keys

/// What a page has for a picture on a telephone [px], with a margin of 11 px.
inline constexpr double kTelephone = 366.0;

/// A picture so wide can be shrunk to a telephone, and its smallest letters be read [px].
inline constexpr double kShrinking = (kTelephone + 11.0) * kSmall.size / 9.0;

}  // namespace kinestat
