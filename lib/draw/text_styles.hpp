// The styles of text that several pictures share.
#pragma once

#include "draw/svg.hpp"

namespace kinestat {

inline constexpr double kTextSize = 12.0;  ///< of what a picture names [px]
inline constexpr TextStyle kSmall = {.ink = Ink::soft, .size = 11.0};  ///< of remarks and keys

}  // namespace kinestat
