#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/index.hpp"
#include "core/motion_tolerance.hpp"
#include "studies/motion/internal/path_tracker.hpp"

namespace kinestat {

namespace {

// That of two rows and columns, most blocks being dyads, with the same pivots as below.
double sign_of_pair(const double* first, const double* second, int row, int other) {
  const bool is_swapped = std::abs(first[other]) > std::abs(first[row]);
  if (is_swapped) {
    std::swap(row, other);
  }
  const double pivot = first[row];
  const double left = second[other] - second[row] / pivot * first[other];
  if (pivot == 0.0 || left == 0.0) {
    return 0.0;
  }
  return ((pivot < 0.0) != (left < 0.0)) != is_swapped ? -1.0 : 1.0;
}

// The sign of the determinant of n x n entries, column by column, which it uses up.
double sign_of_determinant(std::span<double> entries, int n) {
  bool is_negative = false;
  const auto entry = [&](int row, int column) -> double& { return entries[at(column * n + row)]; };
  for (int step = 0; step < n; ++step) {
    int best = step;
    for (int r = step + 1; r < n; ++r) {
      best = std::abs(entry(r, step)) > std::abs(entry(best, step)) ? r : best;
    }
    const double pivot = entry(best, step);
    if (pivot == 0.0) {
      return 0.0;
    }
    is_negative = is_negative != ((pivot < 0.0) != (best != step));
    for (int c = step; c < n && best != step; ++c) {
      std::swap(entry(best, c), entry(step, c));
    }
    for (int c = step + 1; c < n; ++c) {
      const double share = entry(step, c) / pivot;
      for (int r = step + 1; r < n && share != 0.0; ++r) {
        entry(r, c) -= share * entry(r, step);
      }
    }
  }
  return is_negative ? -1.0 : 1.0;
}

void gather_block(const std::vector<double>& matrix,
                  int row_count,
                  const ClosureBlock& block,
                  std::vector<double>& entries) {
  entries.clear();
  for (const int c : block.columns) {
    for (const int r : block.rows) {
      entries.push_back(matrix[at(c * row_count + r)]);
    }
  }
}

}  // namespace

// Only those that change: teeth roll by constant factors.
template <class Frames>
void PathTracker<Frames>::find_blocks() {
  std::vector<int> column_of(at(system_.rate_count()), -1);
  for (std::size_t i = 0; i < unknown_.size(); ++i) {
    column_of[at(unknown_[i])] = static_cast<int>(i);
  }
  std::vector<std::vector<int>> row_columns;
  for (const RatesOfRow& rates : system_.rates_of_rows()) {
    std::vector<int>& columns = row_columns.emplace_back();
    for (const int rate : rates.all) {
      if (column_of[at(rate)] >= 0) {
        columns.push_back(column_of[at(rate)]);
      }
    }
  }
  blocks_ = find_closure_blocks(row_columns, static_cast<int>(unknown_.size()));
  const int first_rolling = system_.row_count() - rolling_count_;
  std::erase_if(blocks_, [&](const ClosureBlock& one) {
    return std::ranges::all_of(one.rows, [&](int row) { return row >= first_rolling; });
  });
  if (blocks_.size() < 2) {
    blocks_.clear();
  }
}

template <class Frames>
void PathTracker<Frames>::find_block_signs(PathPoint& point) {
  if (!is_square_) {
    return;
  }
  point.block_signs.resize(blocks_.size());
  const int row_count = system_.row_count();
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const auto& [rows, columns] = blocks_[b];
    if (rows.size() == 2 && columns.size() == 2) {
      point.block_signs[b] = sign_of_pair(matrix_.data() + columns[0] * row_count,
                                          matrix_.data() + columns[1] * row_count,
                                          rows[0],
                                          rows[1]);
      continue;
    }
    if (rows.size() != columns.size()) {
      point.block_signs[b] = 0.0;  // One holds too much, so that another is open, always.
      continue;
    }
    gather_block(matrix_, row_count, blocks_[b], augmented_);
    point.block_signs[b] = sign_of_determinant(augmented_, static_cast<int>(columns.size()));
  }
}

template <class Frames>
bool PathTracker<Frames>::keeps_orientation(const PathPoint& now, const PathPoint& next) {
  if (blocks_.empty()) {
    return orientation(now.matrix, next.matrix, static_cast<int>(unknown_.size())) >= 0.0;
  }
  std::vector<double> a;
  std::vector<double> b;
  return std::ranges::all_of(blocks_, [&](const ClosureBlock& block) {
    gather_block(now.matrix, system_.row_count(), block, a);
    gather_block(next.matrix, system_.row_count(), block, b);
    return orientation(a, b, static_cast<int>(block.columns.size())) >= 0.0;
  });
}

// Of one of the blocks; of the whole closure where it is one, with the tangent.
template <class Frames>
double PathTracker<Frames>::part_orientation(const ArcPoint& a, const ArcPoint& b, int part) {
  if (part < 0) {
    return arc_orientation(a, b);
  }
  const ClosureBlock& block = blocks_[at(part)];
  std::vector<double> of_a;
  std::vector<double> of_b;
  gather_block(a.matrix, system_.row_count(), block, of_a);
  gather_block(b.matrix, system_.row_count(), block, of_b);
  return orientation(of_a, of_b, static_cast<int>(block.columns.size()));
}

// The parts between whose positions at a and b a singular one lies; -1 is the whole. Where the
// drives turn back each block is singular without any crossing: there the whole decides.
template <class Frames>
std::vector<int> PathTracker<Frames>::turned_over(const ArcPoint& a, const ArcPoint& b) {
  const bool runs_on = std::min(a.tangent.back(), b.tangent.back()) > kFlatVelocity;
  if (blocks_.empty() || !runs_on) {
    return arc_orientation(a, b) > 0.0 ? std::vector<int>() : std::vector<int>{-1};
  }
  std::vector<int> parts;
  for (std::size_t part = 0; part < blocks_.size(); ++part) {
    if (!(part_orientation(a, b, static_cast<int>(part)) > 0.0)) {
      parts.push_back(static_cast<int>(part));
    }
  }
  return parts;
}

template void PathTracker<PlanarFrames>::find_blocks();
template void PathTracker<PlanarFrames>::find_block_signs(PathPoint&);
template bool PathTracker<PlanarFrames>::keeps_orientation(const PathPoint&, const PathPoint&);
template double PathTracker<PlanarFrames>::part_orientation(const ArcPoint&, const ArcPoint&, int);
template std::vector<int> PathTracker<PlanarFrames>::turned_over(const ArcPoint&, const ArcPoint&);
template void PathTracker<SpatialFrames>::find_blocks();
template void PathTracker<SpatialFrames>::find_block_signs(PathPoint&);
template bool PathTracker<SpatialFrames>::keeps_orientation(const PathPoint&, const PathPoint&);
template double PathTracker<SpatialFrames>::part_orientation(const ArcPoint&, const ArcPoint&, int);
template std::vector<int> PathTracker<SpatialFrames>::turned_over(const ArcPoint&, const ArcPoint&);

}  // namespace kinestat
