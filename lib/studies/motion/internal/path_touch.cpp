#include <algorithm>
#include <cmath>

#include "studies/motion/internal/motion_limits.hpp"
#include "studies/motion/internal/path_tracker.hpp"

namespace kinestat {

// Where two motions cross at once the determinant comes down to zero and keeps its sign, and the
// reciprocal condition number falls to zero and rises again. Looks into a step in which it may: if
// it goes on to fall as in the step before, and rises as fast.
template <class Frames>
void PathTracker<Frames>::look_for_touch(const PathPoint& before, const PathPoint& now) {
  if (!looks_for_touches_) {
    return;
  }
  const double way = now.share - before.share;
  const double fell =
      std::exchange(flattening_, (before.reciprocal_condition - now.reciprocal_condition) / way);
  const double deepest = std::max(fell, -flattening_) * way;
  if (fell <= 0.0 ||
      before.reciprocal_condition + now.reciprocal_condition > kMostTouch * deepest) {
    return;
  }
  PathPoint low = before;
  PathPoint high = now;
  PathPoint there = now;
  const auto middle = [&] {
    const double share =
        low.reciprocal_condition / (low.reciprocal_condition + high.reciprocal_condition);
    return low.share + share * (high.share - low.share);
  };
  // By the cubic through both ends and their rates, from the first of them.
  const auto place_between = [&](double share, PathPoint& point) {
    const double h = high.share - low.share;
    const double t = (share - low.share) / h;
    const double s = 1.0 - t;
    for (std::size_t i = 0; i < step_.size(); ++i) {
      step_[i] = t * t * (3.0 - 2.0 * t) * high.arrival[i] +
                 h * t * s * (s * low.rates[i] - t * high.rates[i]);
    }
    point.share = share;
    point.coordinates = low.coordinates;
    point.angles = low.angles;
    point.arrival = step_;
    system_.move(step_, point.coordinates);
    set_drives(share, point.coordinates);
  };
  double width = way;
  double moved = 0.0;
  const auto close_with_rates = [&](PathPoint& point) {
    const bool is_closed = close(point, moved);
    find_rates(point);
    return is_closed;
  };
  while (width * line_.scale > kTouchSurroundings) {
    width *= kNarrows;
    const double share = middle();
    PathPoint left = low;
    PathPoint right = high;
    place_between(std::max(share - 0.5 * width, low.share), left);
    place_between(std::min(share + 0.5 * width, high.share), right);
    const double most = kMostTouch * (low.reciprocal_condition + high.reciprocal_condition) *
                        (right.share - left.share) / (high.share - low.share);
    if (!close_with_rates(left) || !close_with_rates(right) ||
        left.reciprocal_condition + right.reciprocal_condition > most) {
      return;
    }
    for (std::size_t i = 0; i < right.arrival.size(); ++i) {
      right.arrival[i] -= left.arrival[i];
    }
    right.arrival_share = right.share - left.share;
    low = std::move(left);
    high = std::move(right);
  }
  // The cubic between the two ends leaves less than rounding there; Newton would lose digits.
  place_between(middle(), there);
  system_.evaluate(there.coordinates, there.angles);
  gather(unknown_, matrix_);
  qr_.factor(matrix_, system_.row_count(), static_cast<int>(unknown_.size()), kSize);
  const bool is_flat =
      qr_.reciprocal_condition() <=
      kLeftAtCrossing * std::max(low.reciprocal_condition, high.reciprocal_condition);
  if (open_count() == 0 && !is_flat) {
    return;
  }
  note_special(SpecialKind::change_point,
               {.share = there.share,
                .coordinates = there.coordinates,
                .angles = there.angles,
                .tangent = {},
                .matrix = {}},
               kChangePointBracket);
}

template void PathTracker<PlanarFrames>::look_for_touch(const PathPoint&, const PathPoint&);
template void PathTracker<SpatialFrames>::look_for_touch(const PathPoint&, const PathPoint&);

}  // namespace kinestat
