// A writer of SVG elements: shapes and text with colours by role, escaped, and where they lie.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "draw/element_run.hpp"
#include "draw/group_motion.hpp"
#include "draw/paint.hpp"
#include "draw/pixel_box.hpp"

namespace kinestat {

/// An attribute of a group: a name of ours and a value, which is escaped.
using Attribute = std::pair<std::string, std::string>;

/// Writes elements one after the other; lines of one paint that follow each other become one path,
/// likewise filled rectangles and arrow heads, and texts of one style a group that has it.
/// Coordinates must be finite unless a function says what a
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

  /// Separate lines as one path.
  void strokes(std::span<const PixelLine> lines, const Paint& paint);

  /// A line whose end carries a filled head of that length; just the head where it is longer.
  void arrow(PixelPoint from, PixelPoint to, const Paint& paint, double head = 8.0);

  /// A filled arrow head of that length with its tip at `tip`, pointing along `direction`.
  void arrow_head(PixelPoint tip, PixelPoint direction, Ink ink, double length = 8.0);

  /// Diagonal lines at a distance within the box, for areas told apart without colour.
  void hatch(const PixelBox& box, Ink ink, double distance = 5.0);

  /// `place` is on the base line.
  void text(PixelPoint place, std::string_view text, const TextStyle& style);

  /// Texts below each other, in one style that is not turned: each with its height.
  void column(double x,
              std::span<const std::pair<double, std::string>> texts,
              const TextStyle& style);

  /// Groups nest; an empty title is left out, any other is shown when pointed at.
  void open_group(std::string_view title = {}, std::span<const Attribute> attributes = {});

  /// One that moves by itself, without script; no other such group may stand in it. A program that
  /// knows no motion shows it as at the first key frame.
  void open_moving_group(std::string_view title,
                         std::span<const Attribute> attributes,
                         const GroupMotion& motion,
                         const Cycle& cycle);

  /// One that is seen, of a cycle, only from some key frames until the next: `is_seen` is parallel
  /// to Cycle::times, its last never asked for. A program that knows no motion shows it if it is
  /// seen at the first key frame.
  void open_passing_group(std::span<const Attribute> attributes,
                          const std::vector<bool>& is_seen,
                          const Cycle& cycle);

  void close_group();

  /// Everything that the other has drawn; its groups must be closed.
  void add(const Svg& other);

  /// Once more what the group with that `id`, as Svg::id gives it, has drawn, moved by so much:
  /// `bounds` is where it then lies.
  void use(const std::string& id, PixelPoint by, const PixelBox& bounds);

  /// The value for an attribute `id` or, after "#", `href` of a group, made unique where the
  /// picture is embedded; `name` is a word of ours.
  static std::string id(std::string_view name);

  /// All elements so far; every group must be closed.
  const std::string& elements() const;

  /// From now on the lines are kept, which labels keep off.
  void keep_lines() { keeps_lines_ = true; }

  /// Lines and rims of all that is painted since then but grids, tints and what is not shown; of
  /// groups that move, as they are drawn.
  const std::vector<PixelLine>& lines() const { return lines_; }

  /// Where everything drawn so far lies, strokes and widest text included; of a group that moves,
  /// where it comes at the key frames, once it is closed.
  const PixelBox& bounds() const { return bounds_; }

 private:
  void open_element(std::string_view name);
  void attribute(std::string_view name, std::string_view value);
  void attribute(std::string_view name, double value);
  void close_element(const Paint& paint);
  void join(ElementRun::Kind kind, std::string style, std::string part, const std::string& alone);
  void keep(std::span<const PixelPoint> points, bool is_closed, const Paint& paint);
  void keep_rim(PixelPoint centre, double radius, const Paint& paint);
  void include(PixelPoint point, double margin);
  void include(const PixelBox& box);

  // What has been drawn of the group that moves.
  struct MovingGroup {
    GroupMotion motion;
    int depth = 0;  ///< how many groups are open within the picture, itself among them
    std::vector<std::pair<PixelPoint, double>> reach;  ///< points with their margins
  };

  void include_moved(const MovingGroup& group);

  std::string elements_;
  ElementRun run_;
  PixelBox bounds_;
  int open_groups_ = 0;
  int hidden_from_ = 0;  ///< as many groups are open where one that is not shown begins, or 0
  bool keeps_lines_ = false;
  std::vector<PixelLine> lines_;
  std::optional<MovingGroup> moving_;
};

/// Where a text lies, ascenders and descenders included; its corners for a text that is turned.
PixelBox text_box(PixelPoint place, std::string_view text, const TextStyle& style);

}  // namespace kinestat
