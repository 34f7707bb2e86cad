#include <algorithm>
#include <cmath>
#include <numeric>

#include "motion/internal/motion_limits.hpp"
#include "motion/internal/path_tracker.hpp"

namespace kinestat {

// Between 0 and `length`, where the determinant changes its sign.
template <class Frames>
void PathTracker<Frames>::note_change_point(const ArcPoint& from, double length) {
  ArcPoint point = from;
  double low = 0.0;
  double high = length;
  while (high - low > kSurroundings) {
    const double middle = 0.5 * (low + high);
    if (!correct_arc(from, middle, point)) {
      low = high = middle;
      break;
    }
    (arc_orientation(from, point) > 0.0 ? low : high) = middle;
  }
  const std::optional<Surroundings> around = surround(from, 0.5 * (low + high));
  if (!around) {
    note_special(SpecialKind::change_point, from, high - low + kSurroundings);
    return;
  }
  low = around->places.front();
  high = around->places.back();
  const double before = around->determinants.front();
  for (int round = 0; round < kMostBisections; ++round) {
    const double middle = 0.5 * (low + high);
    (around->determinant_at(middle) * before > 0.0 ? low : high) = middle;
  }
  note_special(SpecialKind::change_point, around->point_at(low), kChangePointBracket);
}

template <class Frames>
std::optional<Surroundings> PathTracker<Frames>::surround(const ArcPoint& from, double place) {
  Surroundings around;
  for (const double offset : {-1.5, -0.5, 0.5, 1.5}) {
    ArcPoint point = from;
    if (!correct_arc(from, place + offset * kSurroundings, point)) {
      return std::nullopt;
    }
    around.places.push_back(place + offset * kSurroundings);
    (void)arc_orientation(from, point);
    around.determinants.push_back(qr_.relative_determinant());
    around.points.push_back(std::move(point));
  }
  return around;
}

template void PathTracker<PlanarFrames>::note_change_point(const ArcPoint&, double);
template void PathTracker<SpatialFrames>::note_change_point(const ArcPoint&, double);
template std::optional<Surroundings> PathTracker<PlanarFrames>::surround(const ArcPoint&, double);
template std::optional<Surroundings> PathTracker<SpatialFrames>::surround(const ArcPoint&, double);

}  // namespace kinestat
