#include "studies/sweep/task/lane_rows.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "math/tapes/for_each_machine.hpp"

namespace kinestat {

namespace {

// One number a lane, as a number or a vector of the machine.
using OneLane [[gnu::may_alias]] = std::uint64_t;
using AllLanes = std::uint64_t __attribute__((vector_size(kLanes * sizeof(double)), may_alias));

std::size_t cell_of(std::size_t cell) {
  return cell;
}

std::size_t cell_of(const TapedColumn& column) {
  return column.cell;
}

// Magnitudes have the order of their bits, and what is no number stands above them.
template <class Lanes, class Cell>
[[gnu::always_inline]] inline void add_sizes(const double* cells,
                                             std::span<const Cell> added,
                                             LaneMagnitudes& found) {
  constexpr std::uint64_t kAllButSign = 0x7fff'ffff'ffff'ffff;
  const auto* bits = reinterpret_cast<const Lanes*>(cells);
  auto& largest = reinterpret_cast<Lanes&>(found.largest);
  auto& least = reinterpret_cast<Lanes&>(found.least_below);
  Lanes above = largest;
  Lanes under = least;
  for (const Cell& one : added) {
    const Lanes size = bits[cell_of(one)] & kAllButSign;
    const Lanes below = size - 1;
    above = size > above ? size : above;
    under = below < under ? below : under;
  }
  largest = above;
  least = under;
}

// clang gives its versions a name that only this file knows.
KINESTAT_FOR_EACH_MACHINE
void add_columns_of_all(const double* cells,
                        std::span<const TapedColumn> added,
                        LaneMagnitudes& found) {
  add_sizes<AllLanes>(cells, added, found);
}

KINESTAT_FOR_EACH_MACHINE
void add_cells_of_all(const double* cells,
                      std::span<const std::size_t> added,
                      LaneMagnitudes& found) {
  add_sizes<AllLanes>(cells, added, found);
}

template <std::size_t lanes>
void fill_rows(const double* cells,
               std::span<const TapedColumn> columns,
               std::span<SweepRow> rows,
               std::size_t stride) {
  double* values[lanes];
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    values[lane] = rows[lane * stride].values.data();
  }
  for (const TapedColumn& one : columns) {
    const double* numbers = cells + one.cell * lanes;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      values[lane][one.column] = numbers[lane];
    }
  }
}

}  // namespace

LaneMagnitudes::LaneMagnitudes(double beside) {
  std::ranges::fill(largest, std::bit_cast<std::uint64_t>(beside));
  std::ranges::fill(least_below, std::numeric_limits<std::uint64_t>::max());
}

void LaneMagnitudes::add(const LaneTape::Workspace& workspace,
                         std::span<const TapedColumn> columns) {
  if (workspace.lanes() == kLanes) {
    add_columns_of_all(workspace.numbers(0), columns, *this);
  } else {
    add_sizes<OneLane>(workspace.numbers(0), columns, *this);
  }
}

void LaneMagnitudes::add(const LaneTape::Workspace& workspace, std::span<const std::size_t> ends) {
  if (workspace.lanes() == kLanes) {
    add_cells_of_all(workspace.numbers(0), ends, *this);
  } else {
    add_sizes<OneLane>(workspace.numbers(0), ends, *this);
  }
}

void fill_lanes(const LaneTape::Workspace& workspace,
                std::span<const TapedColumn> columns,
                std::span<SweepRow> rows,
                std::size_t stride) {
  if (workspace.lanes() == kLanes) {
    fill_rows<kLanes>(workspace.numbers(0), columns, rows, stride);
  } else {
    fill_rows<1>(workspace.numbers(0), columns, rows, stride);
  }
}

}  // namespace kinestat
