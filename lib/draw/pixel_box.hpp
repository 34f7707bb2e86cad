// Places and rectangles on a picture.
#pragma once

#include <limits>

namespace kinestat {

/// A place on the picture [px], y downwards.
struct PixelPoint {
  double x = 0.0;
  double y = 0.0;
};

/// A straight one.
struct PixelLine {
  PixelPoint from;
  PixelPoint to;
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

}  // namespace kinestat
