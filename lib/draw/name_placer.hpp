// Finds places for labels where they cover nothing.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "draw/line_grid.hpp"
#include "draw/svg.hpp"

namespace kinestat {

/// Where a label has come to stand.
struct PlacedName {
  PixelPoint place;         ///< on the base line, by the anchor of the style
  PixelBox box;             ///< of the text
  bool is_free = true;      ///< whether it covers nothing and lies within the area
  bool needs_line = false;  ///< so far from what it names that a thin line should join the two
  PixelPoint anchor;        ///< where that line begins
  PixelPoint line_end;      ///< where it meets the label
};

/// Labels are placed one after the other, each at the best of some places around its anchor; the
/// same in every run. What is drawn is announced before, so that labels keep off it: they are
/// rather put far away than upon anything.
class NamePlacer {
 public:
  NamePlacer() = default;

  /// Labels lie within the area.
  explicit NamePlacer(const PixelBox& area) : area_(area) {}

  void keep_off(const PixelBox& box) { boxes_.push_back(box); }

  /// As a label: nothing else may stand there.
  void keep_free(const PixelBox& box) { labels_.push_back(box); }

  void keep_off(PixelPoint from, PixelPoint to);

  void keep_off(std::span<const PixelLine> lines);

  /// From now on a line to a label rather goes farther than across what is drawn.
  void price_crossings() { prices_crossings_ = true; }

  /// The best place for a text of one line at `distance` from the anchor or somewhat further; its
  /// anchor of style is chosen. The label is then kept off by all later ones.
  PlacedName place(PixelPoint anchor,
                   std::string_view text,
                   const TextStyle& style,
                   double distance);

  /// Likewise around the best of several anchors, the first rather than the last.
  PlacedName place(std::span<const PixelPoint> anchors,
                   std::string_view text,
                   const TextStyle& style,
                   double distance);

  /// The best of given places, each the middle of the text; where each covers something, one around
  /// the best of the anchors.
  PlacedName place_at(const std::vector<PixelPoint>& middles,
                      std::span<const PixelPoint> anchors,
                      std::string_view text,
                      const TextStyle& style);

 private:
  // What it costs to stand there, beside a price of its own; at `limit` it is not added up further.
  double cost(const PixelBox& box, double price, double limit) const;
  double line_cost(PixelPoint from, PixelPoint to) const;
  PlacedName take(const PixelBox& box, double cost, const TextStyle& style);

  // A place around an anchor.
  struct Found {
    PixelPoint anchor;
    PixelBox box;
    double cost = std::numeric_limits<double>::infinity();
    double farther = 0.0;  // than the distance
  };

  // The best so far, or a better one.
  Found find_around(PixelPoint anchor,
                    std::string_view text,
                    const TextStyle& style,
                    double distance,
                    const Found& best) const;
  Found find_around(std::span<const PixelPoint> anchors,
                    std::string_view text,
                    const TextStyle& style,
                    double distance,
                    Found best) const;
  PlacedName take(const Found& found, const TextStyle& style);

  std::optional<PixelBox> area_;
  std::vector<PixelBox> boxes_;
  std::vector<PixelBox> labels_;
  LineGrid lines_;
  bool prices_crossings_ = false;
};

/// The box of a text with the room around it into which no other may reach: nearer side by side
/// they would read as one.
PixelBox with_word_gap(const PixelBox& text);

/// Writes the label, and the line from its anchor if it needs one.
void write_label(Svg& svg, const PlacedName& label, std::string_view text, TextStyle style);

}  // namespace kinestat
