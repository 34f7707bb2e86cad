#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/index.hpp"
#include "motion/internal/largest.hpp"
#include "motion/internal/motion_limits.hpp"
#include "motion/internal/path_tracker.hpp"

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

template <class Frames>
ArcPoint PathTracker<Frames>::arc_point(const PathPoint& now) {
  ArcPoint arc{.share = now.share,
               .coordinates = now.coordinates,
               .angles = now.angles,
               .tangent = std::vector<double>(unknown_.size() + 1),
               .matrix = {}};
  for (std::size_t i = 0; i < unknown_.size(); ++i) {
    arc.tangent[i] = now.rates[at(unknown_[i])];
  }
  arc.tangent.back() = scale_;
  system_.evaluate(arc.coordinates, arc.angles);
  augmented_matrix(arc.matrix);
  const std::vector<double> along = arc.tangent;
  find_tangent(along, arc);
  return arc;
}

// The unknowns, then the drives in units of their largest reach.
template <class Frames>
void PathTracker<Frames>::augmented_matrix(std::vector<double>& matrix) const {
  const int rows = system_.row_count();
  gather(unknown_, matrix);
  matrix.resize(matrix.size() + at(rows), 0.0);
  double* last = matrix.data() + unknown_.size() * at(rows);
  for (std::size_t d = 0; d < driven_.size(); ++d) {
    const double* column = system_.jacobian().data() + driven_[d] * rows;
    for (int r = 0; r < rows; ++r) {
      last[r] += column[r] * reach_[d] / scale_;
    }
  }
}

// What of the direction before keeps the network closed; false where nothing of it does.
template <class Frames>
bool PathTracker<Frames>::find_tangent(const std::vector<double>& before, ArcPoint& point) {
  const int columns = static_cast<int>(unknown_.size()) + 1;
  qr_.factor(point.matrix, system_.row_count(), columns);
  const std::vector<double>& null = qr_.null_vectors();
  point.tangent.assign(at(columns), 0.0);
  for (int k = 0; k < columns - qr_.rank(); ++k) {
    const double* z = null.data() + k * columns;
    const double along = std::inner_product(z, z + columns, before.data(), 0.0);
    for (int i = 0; i < columns; ++i) {
      point.tangent[at(i)] += along * z[i];
    }
  }
  const double size = std::sqrt(
      std::inner_product(point.tangent.begin(), point.tangent.end(), point.tangent.begin(), 0.0));
  for (double& value : point.tangent) {
    value /= size;
  }
  return size > 0.0;
}

// By a step of the unknowns and the drives.
template <class Frames>
void PathTracker<Frames>::move_arc(std::span<const double> by, ArcPoint& point) {
  std::ranges::fill(correction_, 0.0);
  for (std::size_t i = 0; i < unknown_.size(); ++i) {
    correction_[at(unknown_[i])] = by[i];
  }
  point.share += by[unknown_.size()] / scale_;
  system_.move(correction_, point.coordinates);
  set_drives(point.share, point.coordinates);
}

// A step of Newton in the plane across the tangent, from which `left` is what the point is off.
template <class Frames>
void PathTracker<Frames>::solve_arc(const std::vector<double>& tangent,
                                    double left,
                                    ArcPoint& point) {
  const std::size_t columns = unknown_.size() + 1;
  const int rows = system_.row_count();
  augmented_matrix(point.matrix);
  augmented_.resize(at(rows + 1) * columns);
  for (std::size_t c = 0; c < columns; ++c) {
    std::copy_n(point.matrix.data() + c * at(rows), rows, augmented_.data() + c * at(rows + 1));
    augmented_[c * at(rows + 1) + at(rows)] = tangent[c];
  }
  qr_.factor(augmented_, rows + 1, static_cast<int>(columns));
  std::ranges::transform(
      system_.residuals(), right_.begin(), [](double residual) { return -residual; });
  right_[at(rows)] = -left;
  qr_.solve(right_, solved_);
}

// The closed point at this length of the arc, or rather of its tangent.
template <class Frames>
bool PathTracker<Frames>::correct_arc(const ArcPoint& from, double length, ArcPoint& to) {
  const std::size_t columns = unknown_.size() + 1;
  to.share = from.share;
  to.coordinates = from.coordinates;
  to.angles = from.angles;
  std::vector<double> corrected(columns, 0.0);
  std::vector<double> ahead = from.tangent;
  for (double& one : ahead) {
    one *= length;
  }
  move_arc(ahead, to);
  if (follows_turns_ && system_.total_turn(correction_) > kMostTurnInStep) {
    return false;
  }
  bool is_last = false;
  for (int round = 0; round <= kMostRounds; ++round) {
    system_.evaluate(to.coordinates, to.angles);
    const double missed = system_.largest_residual();
    if (missed <= kMotionClosure || (is_last && missed <= kAcceptedMisclosure)) {
      system_.follow_angles(to.angles);
      augmented_matrix(to.matrix);
      return find_tangent(from.tangent, to);
    }
    if (!std::isfinite(missed)) {
      return false;
    }
    const double left =
        std::inner_product(corrected.begin(), corrected.end(), from.tangent.begin(), 0.0);
    solve_arc(from.tangent, left, to);
    const std::span<const double> by = std::span(solved_).first(columns);
    for (std::size_t i = 0; i < columns; ++i) {
      corrected[i] += by[i];
    }
    if (largest(corrected) > kMostArcCorrection * std::abs(length)) {
      return false;
    }
    is_last = largest(by) <= kLeastCorrection;
    move_arc(by, to);
  }
  return false;
}

template <class Frames>
bool PathTracker<Frames>::try_arc(const ArcPoint& from, double length, ArcPoint& to) {
  if (!correct_arc(from, length, to)) {
    return false;
  }
  const double cosine =
      std::inner_product(from.tangent.begin(), from.tangent.end(), to.tangent.begin(), 0.0);
  return cosine >= kLeastTangentCosine;
}

// With the tangent as one more row, so that a turn of the drives alone is no singular position.
template <class Frames>
double PathTracker<Frames>::arc_orientation(const ArcPoint& a, const ArcPoint& b) {
  const int columns = static_cast<int>(unknown_.size()) + 1;
  const int rows = system_.row_count();
  const auto with_tangent = [&](const ArcPoint& point) {
    std::vector<double> matrix(at((rows + 1) * columns));
    for (int c = 0; c < columns; ++c) {
      std::copy_n(point.matrix.data() + c * rows, rows, matrix.data() + c * (rows + 1));
      matrix[at(c * (rows + 1) + rows)] = point.tangent[at(c)];
    }
    return matrix;
  };
  return orientation(with_tangent(a), with_tangent(b), columns);
}

template <class Frames>
Arrival PathTracker<Frames>::walk_arc(PathPoint& now, double share) {
  ArcPoint here = arc_point(now);
  ArcPoint there = here;
  double length = kFirstArc;
  int steps = 0;
  while (length > kFinestArc && steps++ < kMostArcs) {
    if (!try_arc(here, length, there)) {
      length *= 0.5;
      continue;
    }
    if (there.tangent.back() <= 0.0) {
      const ArcBracket turns{
          .high = length, .low_value = here.tangent.back(), .high_value = there.tangent.back()};
      find_limit(here, turns, now);
      return Arrival::limit;
    }
    if (there.share >= share) {
      const ArcBracket passes{
          .high = length, .low_value = here.share - share, .high_value = there.share - share};
      if (arrive(here, passes, share, now)) {
        return Arrival::reached;
      }
      length *= 0.5;
      continue;
    }
    if (arc_orientation(here, there) < 0.0) {
      note_change_point(here, length);
    }
    std::swap(here, there);
    length = std::min(2.0 * length, kLongestArc);
  }
  land(here, now);
  return Arrival::lost;
}

// Between the two ends of a step of the arc, the point at which the drives have this share. Where
// the corrector fails, as at a change point, it follows from regular points on both sides.
template <class Frames>
bool PathTracker<Frames>::arrive(const ArcPoint& from,
                                 const ArcBracket& bracket,
                                 double share,
                                 PathPoint& now) {
  ArcPoint there = from;
  const auto miss = [&](double length) -> std::optional<double> {
    return correct_arc(from, length, there) ? std::optional(there.share - share) : std::nullopt;
  };
  const double reached = find_root(bracket, miss);
  const bool is_regular = correct_arc(from, reached, there) &&
                          std::abs(there.share - share) <= kArrivedShare &&
                          arc_orientation(from, there) > 0.0;
  if (!is_regular) {
    const std::optional<Surroundings> around = surround(from, reached);
    if (!around) {
      return false;
    }
    double low = around->places.front();
    double high = around->places.back();
    for (int round = 0; round < kMostBisections; ++round) {
      const double middle = 0.5 * (low + high);
      (around->share_at(middle) < share ? low : high) = middle;
    }
    there = around->point_at(low);
    if (std::abs(there.share - share) > kArrivedShare) {
      return false;
    }
  }
  land(there, now);
  if (now.is_singular) {
    note_special(SpecialKind::change_point, there, kEpsilon);
  } else if (arc_orientation(from, there) < 0.0) {
    note_change_point(from, reached);
    land(there, now);
  }
  now.share = share;
  set_drives(share, now.coordinates);
  if (now.flatness > kFlatClosure && !now.is_singular) {
    double moved = 0.0;
    if (!close(now, moved) || moved > kArrivedShare * scale_) {
      return false;
    }
    find_rates(now);
  }
  return true;
}

// Where the drives turn back: the last component of the tangent is zero.
template <class Frames>
void PathTracker<Frames>::find_limit(const ArcPoint& from,
                                     const ArcBracket& bracket,
                                     PathPoint& now) {
  ArcPoint there = from;
  const auto drive_rate = [&](double length) -> std::optional<double> {
    return correct_arc(from, length, there) ? std::optional(there.tangent.back()) : std::nullopt;
  };
  const double reached = find_root(bracket, drive_rate);
  if (!correct_arc(from, reached, there)) {
    there = from;
  }
  const std::vector<double> rates = now.rates;
  land(there, now);
  now.rates = rates;
  now.is_singular = true;
  // The drives turn back with the square of the arc.
  const double left = there.tangent.back();
  note_special(SpecialKind::limit, there, left * left + now.misclosure + kEpsilon);
}

template <class Frames>
void PathTracker<Frames>::note_special(SpecialKind kind,
                                       const ArcPoint& point,
                                       double uncertainty) {
  special_.push_back({.kind = kind,
                      .share = point.share,
                      .uncertainty = uncertainty / scale_,
                      .drive_values = {},
                      .configuration = {.coordinates = point.coordinates, .angles = point.angles}});
}

template Arrival PathTracker<PlanarFrames>::walk_arc(PathPoint&, double);
template Arrival PathTracker<SpatialFrames>::walk_arc(PathPoint&, double);
template void PathTracker<PlanarFrames>::note_special(SpecialKind, const ArcPoint&, double);
template void PathTracker<SpatialFrames>::note_special(SpecialKind, const ArcPoint&, double);
template bool PathTracker<PlanarFrames>::correct_arc(const ArcPoint&, double, ArcPoint&);
template bool PathTracker<SpatialFrames>::correct_arc(const ArcPoint&, double, ArcPoint&);
template double PathTracker<PlanarFrames>::arc_orientation(const ArcPoint&, const ArcPoint&);
template double PathTracker<SpatialFrames>::arc_orientation(const ArcPoint&, const ArcPoint&);
}  // namespace kinestat
