// The same mechanism as somebody else might have drawn it, and networks that are hard to solve.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/source.hpp"

namespace kinestat {

/// Neither the unit of lengths nor the place of the world origin may change an answer. Methods that
/// take the equations as the textbook writes them do suffer from both.
struct Extreme {
  std::string_view name;
  double scale = 1.0;     ///< by which all lengths are multiplied
  double distance = 0.0;  ///< of the world origin, in sizes of the mechanism
};

/// The first is the mechanism as it is.
inline constexpr std::array<Extreme, 6> kExtremes = {{
    {.name = "as drawn", .scale = 1.0, .distance = 0.0},
    {.name = "lengths 1e-9", .scale = 1.0 / 1e9, .distance = 0.0},
    {.name = "lengths 1e9", .scale = 1e9, .distance = 0.0},
    {.name = "origin 1e3", .scale = 1.0, .distance = 1e3},
    {.name = "origin 1e6", .scale = 1.0, .distance = 1e6},
    {.name = "origin 1e9", .scale = 1.0, .distance = 1e9},
}};

/// Four-bars at 1e-4 and 1e-8 of their size from a dead point, and a train of 80 gears each of
/// which turns 3.5 times slower than the one before. Their paths stand in angle brackets.
std::vector<SourceFile> extreme_networks();

}  // namespace kinestat
