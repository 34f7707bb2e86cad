#include "draw/pixel_box.hpp"

#include <algorithm>

namespace kinestat {

void PixelBox::add(PixelPoint point) {
  left = std::min(left, point.x);
  top = std::min(top, point.y);
  right = std::max(right, point.x);
  bottom = std::max(bottom, point.y);
}

void PixelBox::add(const PixelBox& box) {
  if (!box.is_empty()) {
    add(PixelPoint{.x = box.left, .y = box.top});
    add(PixelPoint{.x = box.right, .y = box.bottom});
  }
}

PixelBox PixelBox::grown(double margin) const {
  return {.left = left - margin,
          .top = top - margin,
          .right = right + margin,
          .bottom = bottom + margin};
}

bool PixelBox::overlaps(const PixelBox& other) const {
  return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
}

}  // namespace kinestat
