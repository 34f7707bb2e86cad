// Places labels where they cover neither each other nor what else must be seen.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "draw/svg.hpp"

namespace kinestat {

/// Remembers what is taken on a picture and finds free places. Deterministic.
class PointLabels {
 public:
  /// Labels stay within the area; points of data may be covered if there is no other way, boxes
  /// that are taken never.
  explicit PointLabels(const PixelBox& area) : area_(area) {}

  void take(const PixelBox& box) { taken_.push_back(box); }

  /// Adds a curve through the points, which labels avoid; a point that is not finite is a gap.
  void avoid(const std::vector<PixelPoint>& points);

  /// Adds points that stand alone.
  void avoid_each(const std::vector<PixelPoint>& points);

  /// Writes the label beside the point, at the nearest of places in a ring around it that is free,
  /// and takes that place; a thin line leads to a label that is not beside its point. False, with
  /// nothing written, where no place is free.
  bool write(PixelPoint point, std::string_view text, const TextStyle& style, Svg& svg);

 private:
  // How many points are covered, or -1 where it cannot stand.
  int cost(const PixelBox& box) const;

  PixelBox area_;
  std::vector<PixelBox> taken_;
  std::vector<PixelPoint> avoided_;
};

}  // namespace kinestat
