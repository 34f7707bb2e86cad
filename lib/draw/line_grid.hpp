// Lines on a picture: whether they cross, and which lie where.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "draw/pixel_box.hpp"

namespace kinestat {

/// Whether two lines have a point in common that is no end of either.
inline bool do_cross(PixelPoint a, PixelPoint b, PixelPoint c, PixelPoint d) {
  const auto side = [](PixelPoint from, PixelPoint to, PixelPoint point) {
    return (to.x - from.x) * (point.y - from.y) - (to.y - from.y) * (point.x - from.x);
  };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

/// Holds lines in pieces, each no longer than a cell of a grid and kept in that of its middle.
class LineGrid {
 public:
  void add(PixelPoint from, PixelPoint to) {
    const int count = 1 + static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / kCell);
    const auto at = [&](double share) {
      return PixelPoint{.x = from.x + share * (to.x - from.x),
                        .y = from.y + share * (to.y - from.y)};
    };
    for (int i = 0; i < count; ++i) {
      const PixelPoint middle = at((i + 0.5) / count);
      cells_[key(cell(middle.x), cell(middle.y))].push_back(
          {.from = at(static_cast<double>(i) / count), .to = at((i + 1.0) / count)});
    }
  }

  /// Calls `use(from, to)` for every piece that may reach into the box.
  template <class Use>
  void visit(const PixelBox& box, Use use) const {
    for (std::int32_t y = cell(box.top - kCell / 2); y <= cell(box.bottom + kCell / 2); ++y) {
      for (std::int32_t x = cell(box.left - kCell / 2); x <= cell(box.right + kCell / 2); ++x) {
        if (const auto at = cells_.find(key(x, y)); at != cells_.end()) {
          for (const PixelLine& piece : at->second) {
            use(piece.from, piece.to);
          }
        }
      }
    }
  }

 private:
  static constexpr double kCell = 16.0;  // [px]

  static std::int32_t cell(double place) {
    return static_cast<std::int32_t>(std::floor(place / kCell));
  }

  static std::uint64_t key(std::int32_t x, std::int32_t y) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32U) |
           static_cast<std::uint32_t>(y);
  }

  std::unordered_map<std::uint64_t, std::vector<PixelLine>> cells_;
};

}  // namespace kinestat
