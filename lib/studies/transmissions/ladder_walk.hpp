// Ladders of gears: walks from gear to gear of a layout with falling ratio.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "studies/transmissions/layouts.hpp"
#include "studies/transmissions/transmission_task.hpp"

namespace kinestat {

/// Gears of a layout by their places, as bits.
using GearMask = std::uint64_t;

inline constexpr int kMostGears = 35;  // 3 or 4 of 7 elements

/// What the gears of a ladder may have by their order, made of the ranges that are asked for.
class LadderBounds {
 public:
  explicit LadderBounds(const LadderTask& task);

  const LadderTask& task() const { return task_; }

  /// The ratio of a forward gear, from 0.
  const ClosedRange& window(int gear) const { return windows_[static_cast<std::size_t>(gear)]; }

  /// Of any forward gear.
  const ClosedRange& forward() const { return forward_; }

  /// All with slack.
  const ClosedRange& step() const { return step_; }

  const ClosedRange& spread() const { return spread_; }

  const ClosedRange& reverse() const { return reverse_; }  ///< of the ratio: below zero

 private:
  LadderTask task_;
  std::vector<ClosedRange> windows_;
  ClosedRange forward_;
  ClosedRange step_;
  ClosedRange spread_;
  ClosedRange reverse_;
};

/// Forward gears from the first, and the reverse gear last if there is one, by their places.
using Ladder = std::vector<std::uint8_t>;

/// The gears of one layout as nodes, joined where one element opens and one engages.
class LadderWalk {
 public:
  LadderWalk(const GenericTrain& train,
             const TransmissionLayout& layout,
             const LadderBounds& bounds);

  /// Whether ratios in these ranges may have a ladder: intervals are handed down the walk. A false
  /// is proved.
  bool may_have_ladder(std::span<const ClosedRange> ratios) const;

  /// Calls with each ladder of these ratios, until it answers false; gears of ratio 0 are none.
  void for_each_ladder(std::span<const double> ratios,
                       const std::function<bool(const Ladder&)>& visit) const;

 private:
  struct Candidates {
    GearMask forward = 0;
    GearMask reverse = 0;
  };

  template <class Visit>
  class Walker;

  Candidates candidates(std::span<const ClosedRange> ratios) const;
  bool may_do(const Candidates& candidates) const;

  const GenericTrain& train_;
  std::vector<LayoutGear> gears_;
  const LadderBounds& bounds_;
  int elements_;
  GearMask direct_ = 0;
  std::array<GearMask, kMostGears> neighbours_{};  // all others where any change will do
  std::array<GearMask, kMostGears> reverse_neighbours_{};
};

}  // namespace kinestat
