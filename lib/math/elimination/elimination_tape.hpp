// An elimination worked out once on a tape, to be played for other entries.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "math/tapes/lane_recorder.hpp"

namespace kinestat {

struct TapedEntry {
  int row = 0;
  int column = 0;
  TapeNumber value;
};

/// Each place has at most one entry.
struct TapedMatrix {
  int rows = 0;
  int columns = 0;
  std::vector<TapedEntry> entries;
};

struct TapedUnknown {
  int column = 0;
  TapeNumber value;
};

/// Where Elimination searches its pivots anew for every matrix, a tape keeps those of the matrix
/// that is recorded and takes the same steps for others. It takes the same decisions on what is
/// rounding, so that the answers of both differ by no more than another order of pivots makes. A
/// lane has no answer where the pivots would no longer be good: one has become too small, a row has
/// grown, or what should follow from the other equations does not. Those pivots, too, on which
/// nothing that is wanted depends must be good, for else the matrix may be singular.
///
/// The right-hand side is zero. Answers with the unknowns of the wanted columns, in their order.
/// Empty if the matrix leaves unknowns open, or if the known ones depend on each other.
std::optional<std::vector<TapeNumber>> record_elimination(const TapedMatrix& matrix,
                                                          std::span<const TapedUnknown> known,
                                                          std::span<const int> wanted,
                                                          LaneRecorder& recorder);

}  // namespace kinestat
