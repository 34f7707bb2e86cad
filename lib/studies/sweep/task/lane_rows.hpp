// Numbers of a tape, of all its lanes at once.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/tolerance.hpp"
#include "math/tapes/lane_tape.hpp"
#include "studies/sweep/report/sweep_rows.hpp"
#include "studies/sweep/task/case_tape.hpp"

namespace kinestat {

/// Of some numbers of each lane: the largest magnitude, with what stands beside them, and the least
/// that is not zero. Lanes beyond those of the workspace stay as they are made.
struct LaneMagnitudes {
  /// `beside` is a magnitude beside which the numbers may be rounding; it is none of them itself.
  explicit LaneMagnitudes(double beside = 0.0);

  void add(const LaneTape::Workspace& workspace, std::span<const TapedColumn> columns);
  void add(const LaneTape::Workspace& workspace, std::span<const std::size_t> cells);

  /// Whether none is too large, and the least cannot be what rounding left of the others. Whether
  /// it is zero only the bounds of an analysis tell, so that this decides on nothing but whether to
  /// ask for them.
  bool are_clear(std::size_t lane) const {
    const auto size = std::bit_cast<double>(largest[lane]);
    const std::uint64_t least = least_below[lane] + 1;
    return size <= kLargestMagnitude &&
           (least == 0 || std::bit_cast<double>(least) >= kSameValue * size);
  }

  alignas(kLanes * sizeof(double)) std::uint64_t largest[kLanes];  ///< the bits
  /// The bits of the least that is not zero, less one: that of zero is the largest number.
  alignas(kLanes * sizeof(double)) std::uint64_t least_below[kLanes];
};

/// Writes the numbers into the rows of one case, of which each lane has one, `stride` apart.
void fill_lanes(const LaneTape::Workspace& workspace,
                std::span<const TapedColumn> columns,
                std::span<SweepRow> rows,
                std::size_t stride);

}  // namespace kinestat
