#include <algorithm>
#include <cmath>
#include <functional>

#include "core/index.hpp"
#include "studies/motion/internal/motion_limits.hpp"
#include "studies/motion/internal/path_tracker.hpp"

namespace kinestat {

namespace {

// The root between 0 and the end of a bracket, by the rule of Illinois; the best found where the
// function has no value.
template <class Function>
double find_root(const ArcBracket& bracket, const Function& value_at) {
  double low = 0.0;
  double high = bracket.high;
  double low_value = bracket.low_value;
  double high_value = bracket.high_value;
  double best = std::abs(low_value) <= std::abs(high_value) ? low : high;
  double least = std::min(std::abs(low_value), std::abs(high_value));
  int side = 0;
  for (int round = 0; round < kMostBisections && least > 0.0; ++round) {
    const double guess = (low_value * high - high_value * low) / (low_value - high_value);
    const double middle = guess > low && guess < high ? guess : 0.5 * (low + high);
    const std::optional<double> value = value_at(middle);
    if (!value || middle == low || middle == high) {
      break;
    }
    if (std::abs(*value) < least) {
      least = std::abs(*value);
      best = middle;
    }
    if ((*value > 0.0) == (low_value > 0.0)) {
      low = middle;
      low_value = *value;
      high_value = side > 0 ? 0.5 * high_value : high_value;
      side = 1;
    } else {
      high = middle;
      high_value = *value;
      low_value = side < 0 ? 0.5 * low_value : low_value;
      side = -1;
    }
    if (least <= kEpsilon || high - low <= kEpsilon * high) {
      break;
    }
  }
  return best;
}

}  // namespace

// Between the two ends of a step of the arc, the point at which the drives have their share.
template <class Frames>
bool PathTracker<Frames>::arrive(const Destination& to, PathPoint& now) {
  if (to.crossing && to.crossing->is_around(to.share)) {
    return arrive_beside(to, *to.crossing, now);
  }
  ArcPoint there = to.from;
  const auto miss = [&](double length) -> std::optional<double> {
    return correct_arc(to.from, length, there) ? std::optional(there.share - to.share)
                                               : std::nullopt;
  };
  const double reached = find_root(to.passes, miss);
  if (!correct_arc(to.from, reached, there) || std::abs(there.share - to.share) > kArrivedShare) {
    return false;
  }
  land(there, now);
  if ((now.is_singular || now.reciprocal_condition <= kFlatClosure) && !to.crossing) {
    const std::optional<Crossing> ahead = find_crossing_near(to.from, reached);
    if (ahead && ahead->is_around(to.share)) {
      return arrive_beside(to, *ahead, now);
    }
  }
  now.share = to.share;
  set_drives(to.share, now.coordinates);
  if (now.reciprocal_condition > kFlatClosure && !now.is_singular) {
    double moved = 0.0;
    if (!close(now, moved) || moved > kArrivedShare * line_.scale) {
      return false;
    }
    find_rates(now);
  }
  if (to.crossing && reached > to.crossing->last()) {
    note_crossing(*to.crossing);
  } else if (now.is_singular && there.tangent.back() > kFlatVelocity) {
    // Two motions cross at once, and the determinant keeps its sign; at a limit none does.
    note_special(SpecialKind::change_point, there, kChangePointBracket);
  }
  return true;
}

// Around a point of the arc at which the closure is flat.
template <class Frames>
std::optional<Crossing> PathTracker<Frames>::find_crossing_near(const ArcPoint& from,
                                                                double reached) {
  const double length = reached + 4.0 * kSurroundings;
  if (blocks_.empty()) {
    return find_crossing(from, length, {-1});
  }
  ArcPoint behind = from;
  const std::vector<int> parts =
      correct_arc(from, length, behind) ? turned_over(from, behind) : std::vector<int>();
  return parts.empty() ? std::nullopt : find_crossing(from, length, parts);
}

// So near a change point that Newton would lose digits: the position follows from regular ones on
// both sides, and the way goes on from where this arc began.
template <class Frames>
bool PathTracker<Frames>::arrive_beside(const Destination& to,
                                        const Crossing& crossing,
                                        PathPoint& now) {
  double low = crossing.around.places.front();
  double high = crossing.around.places.back();
  for (int round = 0; round < kMostBisections; ++round) {
    const double middle = 0.5 * (low + high);
    (crossing.around.share_at(middle) < to.share ? low : high) = middle;
  }
  const ArcPoint there = crossing.around.point_at(low);
  if (std::abs(there.share - to.share) > kArrivedShare) {
    return false;
  }
  land(there, now);
  now.share = to.share;
  set_drives(to.share, now.coordinates);
  const bool has_passed = low >= crossing.last() - kChangePointBracket;
  if (has_passed) {
    note_crossing(crossing);
  }
  resumption_ = {.before = to.from,
                 .behind = crossing.around.points.back(),
                 .is_at = std::abs(low - crossing.last()) <= kChangePointBracket,
                 .has_passed = crossing.is_noted || has_passed};
  return true;
}

// To the present line of the drives.
template <class Frames>
void PathTracker<Frames>::turn_resumption(const DriveLine& last) {
  const int sense = line_.sense_in(last);
  Resumption beside = *std::exchange(resumption_, std::nullopt);
  if (sense == 0) {
    resumption_ = lead_around(beside, last);
    return;
  }
  if (sense < 0 && !beside.behind) {
    return;
  }
  if (sense < 0) {
    std::swap(beside.before, *beside.behind);
    beside.has_passed = beside.is_at || !beside.has_passed;
  }
  ArcPoint& before = beside.before;
  before.share = line_.share_of(last, before.share);
  if (sense < 0) {
    // The last component and column are those of the drives, which now run the other way.
    const double by_drives = before.tangent.back();
    std::ranges::transform(before.tangent, before.tangent.begin(), std::negate());
    before.tangent.back() = by_drives;
    const auto drives = before.matrix.end() - system_.row_count();
    std::transform(drives, before.matrix.end(), drives, std::negate());
  }
  beside.behind.reset();
  resumption_ = std::move(beside);
}

// Where the drives leave their line beside a change point: a way from the regular point before it
// to one that lies before it on the new line.
template <class Frames>
std::optional<Resumption> PathTracker<Frames>::lead_around(const Resumption& beside,
                                                           const DriveLine& last) {
  std::vector<double> from;
  double distance = kStepToStart;
  for (std::size_t d = 0; d < driven_.size(); ++d) {
    from.push_back(last.value(d, beside.before.share));
    distance = std::max(distance, std::abs(line_.from[d] - from.back()));
  }
  const double share = -distance / line_.scale;
  std::vector<double> to;
  for (std::size_t d = 0; d < driven_.size(); ++d) {
    to.push_back(line_.value(d, share));
  }
  const DriveLine next = std::exchange(line_, DriveLine::between(from, to));
  const std::vector<SpecialPosition> passed = take_special();
  PathPoint point = make_point();
  point.coordinates = beside.before.coordinates;
  point.angles = beside.before.angles;
  double moved = 0.0;
  bool is_there = close(point, moved);
  if (is_there) {
    find_rates(point);
    PathPoint none = make_point();
    is_there = advance(point, none, 1.0) == Arrival::reached && !resumption_;
  }
  const bool has_crossed = take_special().size() % 2 == 1;
  resumption_.reset();
  special_ = passed;
  line_ = next;
  point.share = share;
  if (!is_there || !close(point, moved)) {
    return std::nullopt;
  }
  find_rates(point);
  // What lies between the new point and the present one is behind the way that begins.
  return Resumption{.before = arc_point(point),
                    .behind = std::nullopt,
                    .is_at = beside.is_at,
                    .has_passed = beside.is_at || has_crossed != beside.has_passed};
}

// Where the drives turn back on the way to `there`, which becomes that point: the last component of
// the tangent is zero. The length of the arc to it.
template <class Frames>
double PathTracker<Frames>::find_limit(const ArcPoint& from, double length, ArcPoint& there) {
  const ArcBracket bracket{
      .high = length, .low_value = from.tangent.back(), .high_value = there.tangent.back()};
  const auto drive_rate = [&](double at) -> std::optional<double> {
    return correct_arc(from, at, there) ? std::optional(there.tangent.back()) : std::nullopt;
  };
  const double reached = find_root(bracket, drive_rate);
  if (!correct_arc(from, reached, there)) {
    there = from;
    return 0.0;
  }
  return reached;
}

// Where another branch crosses at the very limit, as circuits do that turn back together: the point
// follows from regular ones on both sides. Empty where the crossing is beside the limit, for a
// shorter step to find, or where that branch leads on.
template <class Frames>
std::optional<ArcPoint> PathTracker<Frames>::find_limit_at_crossing(const ArcPoint& from,
                                                                    double length,
                                                                    ArcPoint to) {
  const double reached = find_limit(from, length, to);
  for (const double share : {0.01, 0.1, 1.0}) {
    const double spacing = share * kSurroundings;
    const auto around = surround(from, {.place = reached, .spacing = spacing}, {-1});
    if (!around || around->points.front().tangent.back() <= 0.0 ||
        around->points.back().tangent.back() >= 0.0) {
      continue;
    }
    const auto zero = [&](const std::function<double(double)>& value_at) {
      double low = around->places.front();
      double high = around->places.back();
      const bool is_low_negative = value_at(low) < 0.0;
      for (int round = 0; round < kMostBisections; ++round) {
        const double middle = 0.5 * (low + high);
        ((value_at(middle) < 0.0) == is_low_negative ? low : high) = middle;
      }
      return low;
    };
    const double place = zero([&](double at) { return around->point_at(at).tangent.back(); });
    const double crossing = zero([&](double at) { return around->determinant_at(0, at); });
    ArcPoint limit = around->point_at(place);
    set_drives(limit.share, limit.coordinates);
    system_.evaluate(limit.coordinates, limit.angles);
    const double rounding = std::max(kGapAtCrossing, rounding_of(limit.coordinates));
    if (system_.largest_residual() <= (has_surplus_ ? kSilentCorrection : rounding) &&
        std::abs(place - crossing) <= std::max(kChangePointBracket, around->uncertainty(0))) {
      return leads_on(limit) ? std::nullopt : std::optional(limit);
    }
  }
  return std::nullopt;
}

// Whether the drives move in any motion that is possible at a point where two branches cross: by
// more than points between regular ones leave.
template <class Frames>
bool PathTracker<Frames>::leads_on(const ArcPoint& crossing) {
  const int columns = static_cast<int>(unknown_.size()) + 1;
  qr_.factor(crossing.matrix, system_.row_count(), columns);
  qr_.limit_rank(std::max(columns - 2, 0));
  const std::vector<double>& null = qr_.null_vectors();
  for (std::size_t end = at(columns); end <= null.size(); end += at(columns)) {
    if (std::abs(null[end - 1]) > kFlatClosure) {
      return true;
    }
  }
  return false;
}

template <class Frames>
void PathTracker<Frames>::stop_at_limit(const ArcPoint& limit, double uncertainty, PathPoint& now) {
  const std::vector<double> rates = now.rates;
  land(limit, now);
  now.rates = rates;
  now.is_singular = true;
  // The drives turn back with the square of the arc.
  const double left = limit.tangent.back();
  note_special(SpecialKind::limit, limit, uncertainty + left * left + now.closure_error + kEpsilon);
}

template bool PathTracker<PlanarFrames>::arrive(const Destination&, PathPoint&);
template double PathTracker<PlanarFrames>::find_limit(const ArcPoint&, double, ArcPoint&);
template double PathTracker<SpatialFrames>::find_limit(const ArcPoint&, double, ArcPoint&);
template std::optional<ArcPoint> PathTracker<PlanarFrames>::find_limit_at_crossing(const ArcPoint&,
                                                                                   double,
                                                                                   ArcPoint);
template std::optional<ArcPoint> PathTracker<SpatialFrames>::find_limit_at_crossing(const ArcPoint&,
                                                                                    double,
                                                                                    ArcPoint);
template void PathTracker<PlanarFrames>::stop_at_limit(const ArcPoint&, double, PathPoint&);
template void PathTracker<SpatialFrames>::stop_at_limit(const ArcPoint&, double, PathPoint&);
template void PathTracker<PlanarFrames>::turn_resumption(const DriveLine&);
template bool PathTracker<SpatialFrames>::arrive(const Destination&, PathPoint&);
template void PathTracker<SpatialFrames>::turn_resumption(const DriveLine&);

}  // namespace kinestat
