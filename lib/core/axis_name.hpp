// What the axes of the world are called.
#pragma once

#include <array>

namespace kinestat {

inline constexpr std::array<const char*, 3> kAxisNames = {"x", "y", "z"};

}  // namespace kinestat
