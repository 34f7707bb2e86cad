// How many decimal digits may be asked for.
#pragma once

namespace kinestat {

/// What a double has.
inline constexpr int kDoubleDigits = 16;

/// What is more than a double has.
inline constexpr int kLeastDigits = 17;

/// More are not worked out.
inline constexpr int kMostDigits = 100;

}  // namespace kinestat
