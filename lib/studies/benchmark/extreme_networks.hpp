// Networks that are hard to solve, as files.
#pragma once

#include <vector>

#include "core/source.hpp"

namespace kinestat {

/// Four-bars at 1e-4 and 1e-8 of their size from a dead point, and a train of 80 gears each of
/// which turns 3.5 times slower than the one before. Their paths stand in angle brackets.
std::vector<SourceFile> extreme_networks();

}  // namespace kinestat
