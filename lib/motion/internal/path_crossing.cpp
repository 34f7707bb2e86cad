#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "motion/internal/motion_limits.hpp"
#include "motion/internal/path_tracker.hpp"

namespace kinestat {

// False where the step leads to a branch that comes near and does not cross: the arc bends there,
// and a shorter step follows it.
template <class Frames>
bool PathTracker<Frames>::crosses_at_most(const ArcPoint& from,
                                          double length,
                                          const ArcPoint& to,
                                          std::optional<Crossing>& crossing) {
  if (arc_orientation(from, to) > 0.0) {
    return true;
  }
  crossing = find_crossing(from, length);
  return crossing.has_value() && to.tangent.back() > 0.0;
}

// Between 0 and `length`, where the determinant changes its sign at a closed position.
template <class Frames>
std::optional<Crossing> PathTracker<Frames>::find_crossing(const ArcPoint& from, double length) {
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
  // Nearer where the arc bends; farther where a fast joint makes it long.
  std::optional<Crossing> best;
  for (const double share : {1.0, 0.1, 0.01, 10.0, 100.0, 1000.0}) {
    auto crossing = find_crossing_in(from, 0.5 * (low + high), share * kSurroundings);
    // Beside a crossing that lies behind, its surroundings reach beyond the step.
    const bool is_on_way = crossing && crossing->place >= 0.0 && crossing->place <= length;
    if (is_on_way && (!best || crossing->uncertainty < best->uncertainty)) {
      best = std::move(crossing);
    }
    if (best && best->uncertainty <= kChangePointBracket) {
      break;
    }
  }
  return best;
}

template <class Frames>
std::optional<Crossing> PathTracker<Frames>::find_crossing_in(const ArcPoint& from,
                                                              double place,
                                                              double spacing) {
  std::optional<Surroundings> around = surround(from, place, spacing);
  if (!around || around->determinants.front() * around->determinants.back() >= 0.0) {
    return std::nullopt;
  }
  double low = around->places.front();
  double high = around->places.back();
  const double before = around->determinants.front();
  for (int round = 0; round < kMostBisections; ++round) {
    const double middle = 0.5 * (low + high);
    (around->determinant_at(middle) * before > 0.0 ? low : high) = middle;
  }
  // Branches that only come near each other leave a gap there, or a determinant that jumps.
  ArcPoint point = around->point_at(low);
  set_drives(point.share, point.coordinates);
  system_.evaluate(point.coordinates, point.angles);
  augmented_matrix(point.matrix);
  (void)arc_orientation(from, point);
  const double left = std::abs(qr_.relative_determinant());
  if (!(system_.largest_residual() <= kSilentCorrection) ||
      left > kLeftAtCrossing * std::abs(before)) {
    return std::nullopt;
  }
  return Crossing{.place = low,
                  .uncertainty = std::max(
                      {kChangePointBracket, around->uncertainty(), system_.largest_residual()}),
                  .around = *std::move(around)};
}

template <class Frames>
std::optional<Surroundings> PathTracker<Frames>::surround(const ArcPoint& from,
                                                          double place,
                                                          double spacing) {
  Surroundings around;
  for (const double offset : {-1.5, -0.5, 0.5, 1.5}) {
    ArcPoint point = from;
    if (!correct_arc(from, place + offset * spacing, point)) {
      return std::nullopt;
    }
    around.places.push_back(place + offset * spacing);
    (void)arc_orientation(from, point);
    around.determinants.push_back(qr_.relative_determinant());
    around.flatness = qr_.flatness();
    around.points.push_back(std::move(point));
  }
  return around;
}

template <class Frames>
void PathTracker<Frames>::note_crossing(const Crossing& crossing) {
  if (!crossing.is_noted) {
    note_special(
        SpecialKind::change_point, crossing.around.point_at(crossing.place), crossing.uncertainty);
  }
}

template bool PathTracker<PlanarFrames>::crosses_at_most(const ArcPoint&,
                                                         double,
                                                         const ArcPoint&,
                                                         std::optional<Crossing>&);
template std::optional<Crossing> PathTracker<PlanarFrames>::find_crossing(const ArcPoint&, double);
template void PathTracker<PlanarFrames>::note_crossing(const Crossing&);
template bool PathTracker<SpatialFrames>::crosses_at_most(const ArcPoint&,
                                                          double,
                                                          const ArcPoint&,
                                                          std::optional<Crossing>&);
template std::optional<Crossing> PathTracker<SpatialFrames>::find_crossing(const ArcPoint&, double);
template void PathTracker<SpatialFrames>::note_crossing(const Crossing&);

}  // namespace kinestat
