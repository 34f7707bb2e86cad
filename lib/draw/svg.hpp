// A writer of SVG elements: shapes and text with colours by role, escaped, and where they lie.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "draw/palette.hpp"
#include "draw/text_width.hpp"

namespace kinestat {

/// A place on the picture [px], y downwards.
struct PixelPoint {
  double x = 0.0;
  double y = 0.0;
};

/// A rectangle [px]; empty until something is added.
struct PixelBox {
  double left = std::numeric_limits<double>::infinity();
  double top = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double bottom = -std::numeric_limits<double>::infinity();

  bool is_empty() const { return left > right; }

  double width() const { return is_empty() ? 0.0 : right - left; }

  double height() const { return is_empty() ? 0.0 : bottom - top; }

  PixelPoint centre() const { return {.x = (left + right) / 2, .y = (top + bottom) / 2}; }

  void add(PixelPoint point);

  void add(const PixelBox& box);

  /// With a margin on all sides, which may be negative.
  PixelBox grown(double margin) const;

  bool overlaps(const PixelBox& other) const;
};

/// How a shape is painted.
struct Paint {
  Ink stroke = Ink::ink;
  Ink fill = Ink::none;
  double width = 1.5;       ///< of the stroke [px]
  std::string dash = {};    ///< dashes and gaps [px]; empty: full
  double opacity = 1.0;     ///< of the fill
  bool round_ends = false;  ///< round caps and joins, else flat caps and mitres
};

enum class Anchor { start, middle, end };

struct TextStyle {
  Ink ink = Ink::ink;
  double size = 12.0;  ///< [px]
  Weight weight = Weight::normal;
  Anchor anchor = Anchor::start;
  double turn = 0.0;       ///< about the place, clockwise [degrees]
  bool has_halo = false;   ///< a rim of paper around the letters, for text upon lines
  bool is_italic = false;  ///< for symbols of magnitudes
};

/// An attribute of a group: a name of ours and a value, which is escaped.
using Attribute = std::pair<std::string, std::string>;

/// Writes elements one after the other. Coordinates must be finite unless a function says what a
/// gap is. Names that need an id get it by `id`, so that pictures may stand on one page.
class Svg {
 public:
  void line(PixelPoint from, PixelPoint to, const Paint& paint);

  /// Broken at points that are not finite; a piece of one point is a dot.
  void polyline(std::span<const PixelPoint> points, const Paint& paint);

  /// Closed; all points finite.
  void polygon(std::span<const PixelPoint> corners, const Paint& paint);

  void rectangle(const PixelBox& box, const Paint& paint, double corner_radius = 0.0);

  void circle(PixelPoint centre, double radius, const Paint& paint);

  /// The data of a path, absolute commands only; `bounds` is where it lies.
  void path(std::string_view data, const PixelBox& bounds, const Paint& paint);

  /// A line whose end carries a filled head of that length; just the head where it is longer.
  void arrow(PixelPoint from, PixelPoint to, const Paint& paint, double head = 8.0);

  /// A filled arrow head of that length with its tip at `tip`, pointing along `direction`.
  void arrow_head(PixelPoint tip, PixelPoint direction, Ink ink, double length = 8.0);

  /// Diagonal lines at a distance within the box, for areas told apart without colour.
  void hatch(const PixelBox& box, Ink ink, double distance = 5.0);

  /// `place` is on the base line.
  void text(PixelPoint place, std::string_view text, const TextStyle& style);

  /// Groups nest; an empty title is left out, any other is shown when pointed at.
  void open_group(std::string_view title = {}, std::span<const Attribute> attributes = {});

  void close_group();

  /// Everything that the other has drawn; its groups must be closed.
  void add(const Svg& other);

  /// The value for an attribute `id` or, after "#", `href` of a group, made unique where the
  /// picture is embedded; `name` is a word of ours.
  static std::string id(std::string_view name);

  /// All elements so far; every group must be closed.
  const std::string& elements() const;

  /// Where everything drawn so far lies, strokes and widest text included.
  const PixelBox& bounds() const { return bounds_; }

 private:
  void open_element(std::string_view name);
  void attribute(std::string_view name, std::string_view value);
  void attribute(std::string_view name, double value);
  void close_element(const Paint& paint);
  void include(PixelPoint point, double margin);

  std::string elements_;
  PixelBox bounds_;
  int open_groups_ = 0;
};

/// Where a text lies, ascenders and descenders included; its corners for a text that is turned.
PixelBox text_box(PixelPoint place, std::string_view text, const TextStyle& style);

}  // namespace kinestat
