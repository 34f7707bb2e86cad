// Whether a small graph can be drawn in the plane without crossings.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace kinestat {

inline constexpr int kMostPlanarVertices = 32;

/// Of a graph of up to kMostPlanarVertices vertices; loops and repeated edges change nothing
/// (Demoucron, Malgrange and Pertuiset 1964).
bool is_planar(int vertices, std::span<const std::array<std::uint8_t, 2>> edges);

}  // namespace kinestat
