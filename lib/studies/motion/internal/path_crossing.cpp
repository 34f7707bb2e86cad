#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "studies/motion/internal/motion_limits.hpp"
#include "studies/motion/internal/path_tracker.hpp"

namespace kinestat {

// False where the step leads to a branch that comes near and does not cross: the arc bends there,
// and a shorter step follows it; or where more crossings lie in it than share their surroundings.
template <class Frames>
bool PathTracker<Frames>::crosses_at_most(const ArcPoint& from,
                                          double length,
                                          const ArcPoint& to,
                                          std::optional<Crossing>& crossing) {
  const std::vector<int> parts = turned_over(from, to);
  if (parts.empty()) {
    return true;
  }
  crossing = find_crossing(from, length, parts);
  return crossing.has_value() && crossing->places.size() == parts.size() && to.tangent.back() > 0.0;
}

// Between 0 and `length`, where the first determinant changes its sign at a closed position.
template <class Frames>
std::optional<Crossing> PathTracker<Frames>::find_crossing(const ArcPoint& from,
                                                           double length,
                                                           const std::vector<int>& parts) {
  ArcPoint point = from;
  double low = 0.0;
  double high = length;
  while (high - low > kSurroundings) {
    const double middle = 0.5 * (low + high);
    if (!correct_arc(from, middle, point)) {
      low = high = middle;
      break;
    }
    const bool is_before = std::ranges::all_of(
        parts, [&](int part) { return part_orientation(from, point, part) > 0.0; });
    (is_before ? low : high) = middle;
  }
  // Nearer where the arc bends; farther where a fast joint makes it long.
  std::optional<Crossing> best;
  for (const double share : {1.0, 0.1, 0.01, 10.0, 100.0, 1000.0}) {
    auto crossing = find_crossing_in(
        from, {.place = 0.5 * (low + high), .spacing = share * kSurroundings}, parts);
    // Beside a crossing that lies behind, its surroundings reach beyond the step.
    const bool is_on_way = crossing && crossing->first() >= 0.0 && crossing->last() <= length;
    if (is_on_way && (!best || crossing->uncertainty() < best->uncertainty())) {
      best = std::move(crossing);
    }
    if (best && best->uncertainty() <= kChangePointBracket) {
      break;
    }
  }
  return best;
}

template <class Frames>
std::optional<Crossing> PathTracker<Frames>::find_crossing_in(const ArcPoint& from,
                                                              Vicinity at,
                                                              const Parts& parts) {
  std::optional<Surroundings> around = surround(from, at, parts);
  // Where the drives turn back, of this branch or of one across a gap, all that they lead is
  // singular at once.
  if (!around || !around->runs_on()) {
    return std::nullopt;
  }
  Crossing crossing;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const auto& determinants = around->parts[part].determinants;
    if (determinants.front() * determinants.back() >= 0.0) {
      continue;  // Farther away, if anywhere.
    }
    const std::optional<ChangePlace> found = find_change_place(from, *around, part);
    if (!found) {
      return std::nullopt;
    }
    crossing.places.push_back(*found);
  }
  if (crossing.places.empty()) {
    return std::nullopt;
  }
  std::ranges::sort(crossing.places, {}, &ChangePlace::place);
  crossing.around = *std::move(around);
  return crossing;
}

template <class Frames>
std::optional<ChangePlace> PathTracker<Frames>::find_change_place(const ArcPoint& from,
                                                                  const Surroundings& around,
                                                                  std::size_t part) {
  double low = around.places.front();
  double high = around.places.back();
  const double before = around.parts[part].determinants.front();
  for (int round = 0; round < kMostBisections; ++round) {
    const double middle = 0.5 * (low + high);
    (around.determinant_at(part, middle) * before > 0.0 ? low : high) = middle;
  }
  // Branches that only come near each other leave a gap there, or a determinant that jumps.
  ArcPoint point = around.point_at(low);
  set_drives(point.share, point.coordinates);
  system_.evaluate(point.coordinates, point.angles);
  augmented_matrix(point.matrix);
  (void)part_orientation(from, point, around.parts[part].part);
  const double left = std::abs(qr_.relative_determinant());
  const double missed = system_.largest_residual();
  const double rounding = std::max(kGapAtCrossing, rounding_of(point.coordinates));
  if (!(missed <= (has_surplus_ ? kSilentCorrection : rounding)) ||
      left > kLeftAtCrossing * std::abs(before)) {
    return std::nullopt;
  }
  return ChangePlace{
      .place = low,
      .uncertainty = std::max({kChangePointBracket, around.uncertainty(part), missed})};
}

template <class Frames>
std::optional<Surroundings> PathTracker<Frames>::surround(const ArcPoint& from,
                                                          Vicinity at,
                                                          const Parts& parts) {
  Surroundings around;
  for (const int part : parts) {
    around.parts.push_back({.part = part});
  }
  for (std::size_t i = 0; i < 4; ++i) {
    ArcPoint point = from;
    const double there = at.place + (static_cast<double>(i) - 1.5) * at.spacing;
    if (!correct_arc(from, there, point)) {
      return std::nullopt;
    }
    around.places.push_back(there);
    for (Surroundings::Part& part : around.parts) {
      (void)part_orientation(from, point, part.part);
      part.determinants[i] = qr_.relative_determinant();
      part.reciprocal_condition = qr_.reciprocal_condition();
    }
    around.points.push_back(std::move(point));
  }
  return around;
}

// One event for parts that are singular in one position, as far as that can be told.
template <class Frames>
void PathTracker<Frames>::note_crossing(const Crossing& crossing) {
  std::optional<ChangePlace> last;
  for (const ChangePlace& one : crossing.places) {
    const bool is_same = last && one.place - last->place <= one.uncertainty + last->uncertainty;
    if (!crossing.is_noted && !is_same) {
      note_special(SpecialKind::change_point, crossing.around.point_at(one.place), one.uncertainty);
    }
    last = one;
  }
}

template bool PathTracker<PlanarFrames>::crosses_at_most(const ArcPoint&,
                                                         double,
                                                         const ArcPoint&,
                                                         std::optional<Crossing>&);
template std::optional<Crossing> PathTracker<PlanarFrames>::find_crossing(const ArcPoint&,
                                                                          double,
                                                                          const std::vector<int>&);
template void PathTracker<PlanarFrames>::note_crossing(const Crossing&);
template bool PathTracker<SpatialFrames>::crosses_at_most(const ArcPoint&,
                                                          double,
                                                          const ArcPoint&,
                                                          std::optional<Crossing>&);
template std::optional<Crossing> PathTracker<SpatialFrames>::find_crossing(const ArcPoint&,
                                                                           double,
                                                                           const std::vector<int>&);
template void PathTracker<SpatialFrames>::note_crossing(const Crossing&);

}  // namespace kinestat
