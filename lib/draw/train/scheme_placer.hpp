// From the grid of a section to places in pixels.
#pragma once

#include <set>
#include <vector>

#include "draw/train/scheme_layout.hpp"
#include "draw/train/scheme_routing.hpp"

namespace kinestat {

/// What is farther from its axis is drawn on one side alone [px].
inline constexpr double kMirrorReach = 30.0;

/// All must outlive it. Nets that are mirrored are drawn on both sides of their axis where they are
/// near to it.
class SchemePlacer {
 public:
  SchemePlacer(const SchemeTrain& train,
               const SchemeGrid& grid,
               const SchemeRouting& routing,
               std::set<int> mirrored = {})
      : train_(train), grid_(grid), routing_(routing), mirrored_(std::move(mirrored)) {}

  /// In which tracks and rows something stands or turns.
  void mark_used(std::vector<bool>& is_used, std::vector<bool>& is_used_row) const;

  /// What is drawn, once the grid has been closed up.
  void add_to(SchemeLayout& layout) const;

 private:
  const SchemeWheel& wheel(int i) const { return train_.wheels[static_cast<std::size_t>(i)]; }

  PixelPoint mirror(PixelPoint point) const {
    return {.x = point.x, .y = -2.0 * grid_.base() - point.y};
  }

  DrawnWheel drawn(int w) const;
  DrawnPin drawn(const RoutedPin& pin) const;
  double hub_height(int w) const;
  bool is_fixed(int w) const;
  void add_shafts(SchemeLayout& layout) const;
  bool is_of_half_wheel(int track) const;
  bool goes_outwards(GridCell end) const;
  bool is_of_brake(GridCell end) const;

  const SchemeTrain& train_;
  const SchemeGrid& grid_;
  const SchemeRouting& routing_;
  std::set<int> mirrored_;
};

}  // namespace kinestat
