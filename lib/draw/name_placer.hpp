// Finds places for labels where they cover nothing.
#pragma once

#include <string_view>
#include <vector>

#include "draw/svg.hpp"

namespace kinestat {

/// Where a label has come to stand.
struct PlacedName {
  PixelPoint place;         ///< on the base line, by the anchor of the style
  PixelBox box;             ///< of the text
  bool needs_line = false;  ///< so far from what it names that a thin line should join the two
  PixelPoint line_end;      ///< where that line meets the label
};

/// Labels are placed one after the other, each at the best of some places around its anchor; the
/// same in every run. What is drawn is announced before, so that labels keep off it.
class NamePlacer {
 public:
  /// By how many pixels a label is rather put farther away than upon anything that is drawn.
  explicit NamePlacer(double detour = 0.0) : detour_(detour) {}

  void keep_off(const PixelBox& box) { boxes_.push_back(box); }

  /// As a label: nothing else may stand there.
  void keep_free(const PixelBox& box) { labels_.push_back(box); }

  void keep_off(PixelPoint from, PixelPoint to);

  /// The rim, not what is within.
  void keep_off_circle(PixelPoint centre, double radius);

  /// The best place for a text of one line at `distance` from the anchor or somewhat further; its
  /// anchor of style is chosen. The label is then kept off by all later ones.
  PlacedName place(PixelPoint anchor,
                   std::string_view text,
                   const TextStyle& style,
                   double distance);

  /// The best of given places, each the middle of the text; where each covers another label, or
  /// what a detour would leave free, one around the anchor.
  PlacedName place_at(const std::vector<PixelPoint>& middles,
                      PixelPoint anchor,
                      std::string_view text,
                      const TextStyle& style);

 private:
  struct Segment {
    PixelPoint from;
    PixelPoint to;
  };

  // What it costs to stand there, beside a price of its own; at `limit` it is not added up further.
  double cost(const PixelBox& box, double price, double limit) const;
  double line_cost(PixelPoint from, PixelPoint to) const;
  PlacedName take(const PixelBox& box, const TextStyle& style);

  // A place around an anchor.
  struct Found {
    PixelBox box;
    double cost = 0.0;
    double farther = 0.0;  // than the distance
  };

  Found find_around(PixelPoint anchor,
                    std::string_view text,
                    const TextStyle& style,
                    double distance) const;
  PlacedName take(const Found& found, PixelPoint anchor, const TextStyle& style);

  double detour_ = 0.0;
  std::vector<PixelBox> boxes_;
  std::vector<PixelBox> labels_;
  std::vector<Segment> segments_;
};

/// Writes the label, and the line to its anchor if it needs one.
void write_label(
    Svg& svg, const PlacedName& label, PixelPoint anchor, std::string_view text, TextStyle style);

}  // namespace kinestat
