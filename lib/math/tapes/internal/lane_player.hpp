// Plays the operations of a tape for one lane or for kLanes.
#pragma once

#include <cstdint>
#include <span>

#include "math/tapes/internal/lane_operation.hpp"

namespace kinestat {

struct LaneOperations {
  std::span<const LaneOperation> operations;
  std::span<const LaneProduct> products;
};

/// `cells` has one number a cell, `failures` one entry: not 0 where a demand is not met.
void play_one(const LaneOperations& tape, double* cells, std::int64_t* failures);

/// `cells` has kLanes numbers a cell, aligned to their size, `failures` kLanes entries.
void play_lanes(const LaneOperations& tape, double* cells, std::int64_t* failures);

}  // namespace kinestat
