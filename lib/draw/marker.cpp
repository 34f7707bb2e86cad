#include "draw/marker.hpp"

#include <array>
#include <vector>

#include "core/contract.hpp"

namespace kinestat {

namespace {

std::vector<PixelPoint> corners(int shape, PixelPoint at, double r) {
  switch (shape) {
    case 1:
      return {{.x = at.x - r, .y = at.y - r},
              {.x = at.x + r, .y = at.y - r},
              {.x = at.x + r, .y = at.y + r},
              {.x = at.x - r, .y = at.y + r}};
    case 2:
      return {{.x = at.x, .y = at.y - 1.2 * r},
              {.x = at.x + 1.1 * r, .y = at.y + 0.8 * r},
              {.x = at.x - 1.1 * r, .y = at.y + 0.8 * r}};
    default:
      return {{.x = at.x, .y = at.y - 1.3 * r},
              {.x = at.x + 1.3 * r, .y = at.y},
              {.x = at.x, .y = at.y + 1.3 * r},
              {.x = at.x - 1.3 * r, .y = at.y}};
  }
}

}  // namespace

void draw_marker(int shape, PixelPoint place, Ink ink, double size, Svg& svg) {
  KINESTAT_EXPECTS(shape >= 0);
  const int kind = shape % kMarkerShapes;
  const bool is_hollow = kind >= kMarkerShapes / 2;
  const Paint paint = {.stroke = ink, .fill = is_hollow ? Ink::paper : ink, .width = 1.5};
  const double r = size / 2;
  if (kind % 4 == 0) {
    svg.circle(place, 1.1 * r, paint);
  } else {
    svg.polygon(corners(kind % 4, place, r), paint);
  }
}

}  // namespace kinestat
