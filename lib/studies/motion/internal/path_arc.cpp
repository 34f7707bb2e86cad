#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/index.hpp"
#include "studies/motion/internal/largest.hpp"
#include "studies/motion/internal/motion_limits.hpp"
#include "studies/motion/internal/path_tracker.hpp"

namespace kinestat {

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
  arc.tangent.back() = line_.scale;
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
      last[r] += column[r] * line_.reach[d] / line_.scale;
    }
  }
}

// What of the direction before keeps the network closed; false where nothing of it does.
template <class Frames>
bool PathTracker<Frames>::find_tangent(const std::vector<double>& before, ArcPoint& point) {
  const int columns = static_cast<int>(unknown_.size()) + 1;
  qr_.factor(point.matrix, system_.row_count(), columns);
  qr_.limit_rank(columns - 1);  // Rounded drawings are not singular where they should be.
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
  point.share += by[unknown_.size()] / line_.scale;
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
    // One correction at least: what the tangent led to is off by the error of the tangent.
    const bool is_closed = missed <= kEpsilon || (missed <= kMotionClosure && round > 0);
    if (is_closed || (is_last && missed <= std::max(accepted_, rounding_of(to.coordinates)))) {
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
    is_last = largest(by) <= std::max(kLeastCorrection, rounding_of(to.coordinates));
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
  ArcPoint here = resumption_ ? resumption_->before : arc_point(now);
  bool has_noted = resumption_ && resumption_->has_passed;
  resumption_.reset();
  ArcPoint there = here;
  double length = kFirstArc;
  int steps = 0;
  while (length > kFinestArc && steps++ < kMostArcs) {
    std::optional<Crossing> crossing;
    const bool is_there = try_arc(here, length, there);
    if (!is_there || !crosses_at_most(here, length, there, crossing)) {
      if (is_there && there.tangent.back() <= 0.0) {
        if (const auto limit = find_limit_at_crossing(here, length, there)) {
          stop_at_limit(*limit, kChangePointBracket, now);
          return Arrival::limit;
        }
      }
      length *= 0.5;
      continue;
    }
    if (crossing) {
      crossing->is_noted = has_noted;
    }
    double end = length;
    const bool turns_back = there.tangent.back() <= 0.0;
    if (turns_back) {
      end = find_limit(here, length, there);
      if (there.share < share - kEpsilon) {
        stop_at_limit(there, 0.0, now);
        return Arrival::limit;
      }
    }
    if (turns_back || there.share >= share) {
      const ArcBracket passes{
          .high = end, .low_value = here.share - share, .high_value = there.share - share};
      if (arrive({.from = here, .share = share, .passes = passes, .crossing = crossing}, now)) {
        return Arrival::reached;
      }
      length *= 0.5;
      continue;
    }
    if (crossing) {
      note_crossing(*crossing);
      has_noted = false;
    }
    std::swap(here, there);
    length = std::min(2.0 * length, kLongestArc);
  }
  land(here, now);
  return Arrival::lost;
}

template <class Frames>
void PathTracker<Frames>::note_special(SpecialKind kind,
                                       const ArcPoint& point,
                                       double uncertainty) {
  special_.push_back({.kind = kind,
                      .share = point.share,
                      .uncertainty = uncertainty / line_.scale,
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
template void PathTracker<PlanarFrames>::augmented_matrix(std::vector<double>&) const;
template void PathTracker<SpatialFrames>::augmented_matrix(std::vector<double>&) const;

}  // namespace kinestat
