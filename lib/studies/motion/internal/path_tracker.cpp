#include "studies/motion/internal/path_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/index.hpp"
#include "studies/motion/internal/largest.hpp"
#include "studies/motion/internal/motion_limits.hpp"

namespace kinestat {

template <class Frames>
PathTracker<Frames>::PathTracker(const MotionNetwork& network)
    : system_(network),
      driven_(network.driven_rates),
      passive_count_(static_cast<int>(network.passive_motions.size())),
      arcs_(network.arcs),
      rolling_count_(static_cast<int>(network.rollings.size())),
      follows_turns_(network.angle_count > 0) {
  for (const int rate : driven_) {
    for (const MotionJoint& joint : network.joints) {
      if (joint.rate == rate && joint.coordinate >= 0) {
        drive_coordinates_.push_back(joint.coordinate);
      }
    }
  }
  for (int rate = 0; rate < network.rate_count; ++rate) {
    if (std::ranges::find(driven_, rate) == driven_.end()) {
      unknown_.push_back(rate);
    }
  }
  is_square_ = system_.row_count() == static_cast<int>(unknown_.size()) && passive_count_ == 0;
  has_surplus_ = system_.row_count() > static_cast<int>(unknown_.size()) - passive_count_;
  accepted_ = has_surplus_ ? kAcceptedClosureError : kTrialClosure;
  const std::vector<double> still(driven_.size(), 0.0);
  line_ = DriveLine::between(still, still);
  const std::size_t rates = at(network.rate_count);
  const std::size_t rows = at(system_.row_count());
  right_.resize(rows + 1);
  solved_.resize(rates + 1);
  step_.resize(rates);
  correction_.resize(rates);
  matrix_.resize(rows * unknown_.size());
  trial_ = make_point();
  find_blocks();
}

template <class Frames>
PathPoint PathTracker<Frames>::make_point() const {
  PathPoint point;
  point.coordinates = system_.drawn_coordinates();
  point.angles = system_.drawn_angles();
  point.rates.assign(at(system_.rate_count()), 0.0);
  point.arrival = point.rates;
  return point;
}

template <class Frames>
void PathTracker<Frames>::set_range(std::span<const double> from, std::span<const double> to) {
  const DriveLine last = std::exchange(line_, DriveLine::between(from, to));
  if (resumption_) {
    turn_resumption(last);
  }
  trail_.clear();
  flattening_ = kUnknownFall;
}

template <class Frames>
void PathTracker<Frames>::set_drives(double share, std::span<double> coordinates) const {
  for (std::size_t d = 0; d < driven_.size(); ++d) {
    coordinates[at(drive_coordinates_[d])] = line_.value(d, share);
  }
}

template <class Frames>
void PathTracker<Frames>::gather(std::span<const int> columns, std::vector<double>& matrix) const {
  const int rows = system_.row_count();
  matrix.resize(at(rows) * columns.size());
  const double* from = system_.jacobian().data();
  double* to = matrix.data();
  for (const int column : columns) {
    std::copy_n(from + column * rows, rows, to);
    to += rows;
  }
}

// What may be missed by it: coordinates are large after many turns.
template <class Frames>
double PathTracker<Frames>::rounding_of(std::span<const double> coordinates) {
  return kTurnRoundings * kEpsilon * largest(coordinates);
}

template <class Frames>
bool PathTracker<Frames>::closes_by_least_squares(const PathPoint& point) const {
  return has_surplus_ &&
         point.closure_error > std::max(kTrialClosure, rounding_of(point.coordinates));
}

template <class Frames>
bool PathTracker<Frames>::close(PathPoint& point, double& moved) {
  const int columns = static_cast<int>(unknown_.size());
  const int rows = system_.row_count();
  moved = 0.0;
  double last = kFarCorrection;
  bool is_last = false;
  for (int round = 0; round < kMostRounds; ++round) {
    system_.evaluate(point.coordinates, point.angles);
    point.closure_error = system_.largest_residual();
    gather(unknown_, matrix_);
    qr_.factor(matrix_, rows, columns, kSize);
    // A closed point is polished once more with the factors at hand.
    const bool is_closed = point.closure_error <= kMotionClosure;
    if (point.closure_error <= kEpsilon || is_last) {
      break;
    }
    if (!std::isfinite(point.closure_error)) {
      return false;
    }
    std::ranges::transform(
        system_.residuals(), right_.begin(), [](double residual) { return -residual; });
    qr_.solve(right_, solved_);
    const double size = largest(std::span(solved_).first(unknown_.size()));
    if (size > last && !is_closed && size > rounding_of(point.coordinates)) {
      return false;
    }
    is_last = size <= kLeastCorrection || size > last;
    last = size;
    std::ranges::fill(correction_, 0.0);
    for (std::size_t i = 0; i < unknown_.size(); ++i) {
      correction_[at(unknown_[i])] = solved_[i];
    }
    moved += size;
    system_.move(correction_, point.coordinates);
    for (std::size_t i = 0; i < point.arrival.size(); ++i) {
      point.arrival[i] += correction_[i];
    }
    if (is_closed) {
      break;
    }
  }
  point.sign = qr_.sign();
  find_block_signs(point);
  point.reciprocal_condition = qr_.reciprocal_condition_beside(passive_count_);
  if (!(point.closure_error <= accepted_ ||
        point.closure_error <= rounding_of(point.coordinates))) {
    return false;
  }
  system_.follow_angles(point.angles);
  return true;
}

template <class Frames>
void PathTracker<Frames>::stand_at(const PathPoint& point) {
  system_.evaluate(point.coordinates, point.angles);
  gather(unknown_, matrix_);
  qr_.factor(matrix_, system_.row_count(), static_cast<int>(unknown_.size()), kSize);
}

template <class Frames>
void PathTracker<Frames>::find_rates(PathPoint& point) {
  const int rows = system_.row_count();
  std::ranges::fill(right_, 0.0);
  for (std::size_t d = 0; d < driven_.size(); ++d) {
    const double* column = system_.jacobian().data() + driven_[d] * rows;
    for (int r = 0; r < rows; ++r) {
      right_[at(r)] -= column[r] * line_.reach[d];
    }
    point.rates[at(driven_[d])] = line_.reach[d];
  }
  qr_.solve(right_, solved_);
  for (std::size_t i = 0; i < unknown_.size(); ++i) {
    point.rates[at(unknown_[i])] = solved_[i];
  }
  point.is_singular = open_count() > passive_count_;
  if (!is_square_) {
    point.matrix = matrix_;
  }
}

// How far the drives cannot be followed at all: what the rates miss of the closure.
template <class Frames>
double PathTracker<Frames>::missed_rate(const PathPoint& point) const {
  const int rows = system_.row_count();
  double worst = 0.0;
  for (int r = 0; r < rows; ++r) {
    double sum = 0.0;
    for (int c = 0; c < system_.rate_count(); ++c) {
      sum += system_.jacobian()[at(c * rows + r)] * point.rates[at(c)];
    }
    worst = std::max(worst, std::abs(sum));
  }
  return worst / line_.scale;
}

// Cubic through the last two points and their rates, or better.
template <class Frames>
void PathTracker<Frames>::predict(const PathPoint& now, const PathPoint& before, double step) {
  if (trail_.leads_by(step)) {
    trail_.predict(step_);
    return;
  }
  const double h = now.arrival_share;
  if (!(h > 0.0)) {
    for (std::size_t i = 0; i < step_.size(); ++i) {
      step_[i] = step * now.rates[i];
    }
    return;
  }
  const double t = 1.0 + step / h;
  const double by_arrival = t * t * (3.0 - 2.0 * t) - 1.0;
  const double by_before = h * t * (t - 1.0) * (t - 1.0);
  const double by_now = h * t * t * (t - 1.0);
  for (std::size_t i = 0; i < step_.size(); ++i) {
    step_[i] = by_arrival * now.arrival[i] + by_before * before.rates[i] + by_now * now.rates[i];
  }
}

template <class Frames>
bool PathTracker<Frames>::keeps_branch(const PathPoint& now, const PathPoint& next, double moved) {
  const bool jumps =
      moved > kMostCorrection * largest(next.arrival) && moved > rounding_of(next.coordinates);
  if (next.is_singular || next.reciprocal_condition < kFlatClosure || next.sign != now.sign ||
      jumps || next.block_signs != now.block_signs) {
    return false;
  }
  double change = 0.0;
  for (std::size_t i = 0; i < now.rates.size(); ++i) {
    change = std::max(change, std::abs(next.rates[i] - now.rates[i]));
  }
  if (!is_square_ && !keeps_orientation(now, next)) {
    return false;
  }
  return change <= kMostTangentChange * std::max(largest(now.rates), largest(next.rates));
}

template <class Frames>
bool PathTracker<Frames>::try_step(const PathPoint& now,
                                   const PathPoint& before,
                                   double share,
                                   PathPoint& next) {
  predict(now, before, share - now.share);
  for (std::size_t d = 0; d < driven_.size(); ++d) {
    step_[at(driven_[d])] = (share - now.share) * line_.reach[d];
  }
  const double longest = largest(step_);
  if (longest > kLongestStep || (follows_turns_ && system_.total_turn(step_) > kMostTurnInStep)) {
    return false;
  }
  next.share = share;
  next.arrival_share = share - now.share;
  next.coordinates = now.coordinates;
  next.angles = now.angles;
  next.arrival = step_;
  system_.move(step_, next.coordinates);
  set_drives(share, next.coordinates);
  double moved = 0.0;
  if (!close(next, moved)) {
    return false;
  }
  // Two singular positions in a step would leave all signs.
  if (longest > kNearSingularStep &&
      std::min(now.reciprocal_condition, next.reciprocal_condition) < kNearSingularity) {
    return false;
  }
  find_rates(next);
  if (passive_count_ > 0 && !next.is_singular && !rest_passive(now, next)) {
    return false;
  }
  return keeps_branch(now, next, moved);
}

// What no condition holds goes as far as the rates of both points say, by the trapezoidal rule: a
// prediction that nothing corrects would add its errors to those of the steps before. The rates of
// the least motion have no part in what is open where they are found.
template <class Frames>
bool PathTracker<Frames>::rest_passive(const PathPoint& now, PathPoint& next) {
  const double half = 0.5 * next.arrival_share;
  const std::vector<double>& null = qr_.null_vectors();
  std::ranges::fill(correction_, 0.0);
  for (std::size_t z = 0; z < null.size(); z += unknown_.size()) {
    double beyond = 0.0;
    for (std::size_t i = 0; i < unknown_.size(); ++i) {
      const std::size_t rate = at(unknown_[i]);
      beyond += null[z + i] * (next.arrival[rate] - half * now.rates[rate]);
    }
    for (std::size_t i = 0; i < unknown_.size(); ++i) {
      correction_[at(unknown_[i])] -= beyond * null[z + i];
    }
  }
  system_.move(correction_, next.coordinates);
  for (std::size_t i = 0; i < next.arrival.size(); ++i) {
    next.arrival[i] += correction_[i];
  }
  double moved = 0.0;
  if (!close(next, moved)) {
    return false;
  }
  find_rates(next);
  return true;
}

template <class Frames>
Arrival PathTracker<Frames>::advance(PathPoint& now, PathPoint& before, double share) {
  return arcs_.empty() ? follow(now, before, share) : follow_cables(now, before, share);
}

template <class Frames>
Arrival PathTracker<Frames>::follow(PathPoint& now, PathPoint& before, double share) {
  const double longest = kLongestStep / line_.scale;
  double step = std::min(share - now.share, longest);
  const double least = kFinestShare * step;
  while (now.share < share) {
    const double next = now.share + step >= share - least ? share : now.share + step;
    const bool is_regular = !now.is_singular && !resumption_;
    if (is_regular && try_step(now, before, next, trial_)) {
      PathPoint spare = std::move(before);  // its buffers
      before = std::move(now);
      now = std::move(trial_);
      trial_ = std::move(spare);
      trail_.leave(now.rates, now.arrival, now.arrival_share);
      if (is_square_) {
        look_for_touch(before, now);
      }
      step = std::min(2.0 * step, longest);
      continue;
    }
    step *= 0.5;
    if (step > least && is_regular && now.share + step > now.share) {
      continue;
    }
    const double stretch = now.share + kArcStretch / line_.scale;
    const PathPoint start = now;
    const std::size_t passed = special_.size();
    const Arrival arrival = walk_arc(now, stretch >= share - least ? share : stretch);
    if (is_square_ && !resumption_ && special_.size() == passed) {
      // Past a position that is flat itself, and back.
      const double way = now.share - start.share;
      const double end = now.reciprocal_condition > kFlatClosure ? now.share : now.share + way;
      flattening_ = kUnknownFall;
      if (is_regular && try_step(start, before, end, trial_)) {
        look_for_touch(start, trial_);
      }
      const bool is_behind = special_.size() > passed && special_.back().share > now.share;
      special_.resize(is_behind ? passed : special_.size());
    }
    trail_.clear();
    flattening_ = kUnknownFall;
    now.arrival_share = 0.0;
    step = longest;
    if (arrival != Arrival::reached) {
      return arrival;
    }
  }
  return Arrival::reached;
}

// +1 where no singular position lies between two near ones, -1 where one does: the sign of
// det [Qᵀ b; zᵀ] as that of det [Qᵀ a; zᵀ], Q the range of a and z its null vectors. Where both are
// square it is that of det a · det b.
template <class Frames>
double PathTracker<Frames>::orientation(const std::vector<double>& a,
                                        const std::vector<double>& b,
                                        int columns) {
  if (columns == 0) {
    return 1.0;  // Nothing is open that could turn over.
  }
  const int rows = static_cast<int>(a.size()) / columns;
  qr_.factor(a, rows, columns, kSize);
  const int rank = qr_.rank();
  const std::vector<double>& null = qr_.null_vectors();
  const auto turned = [&](const std::vector<double>& matrix) {
    std::vector<double> result(at(columns * columns));
    for (int c = 0; c < columns; ++c) {
      std::copy_n(matrix.data() + c * rows, rows, right_.begin());
      qr_.turn(right_);
      std::copy_n(right_.begin(), rank, result.begin() + c * columns);
      for (int z = rank; z < columns; ++z) {
        result[at(c * columns + z)] = null[at((z - rank) * columns + c)];
      }
    }
    return result;
  };
  double sign = qr_.turned_sign();
  const std::vector<double> turned_b = turned(b);
  if (rank < columns) {
    qr_.factor(turned(a), columns, columns, kSize);
    sign = qr_.sign();
  }
  qr_.factor(turned_b, columns, columns, kSize);
  return sign * qr_.sign();
}

// `now` becomes the point of the arc.
template <class Frames>
void PathTracker<Frames>::land(const ArcPoint& arc, PathPoint& now) {
  now.share = arc.share;
  now.coordinates = arc.coordinates;
  now.angles = arc.angles;
  system_.evaluate(now.coordinates, now.angles);
  now.closure_error = system_.largest_residual();
  gather(unknown_, matrix_);
  qr_.factor(matrix_, system_.row_count(), static_cast<int>(unknown_.size()), kSize);
  now.sign = qr_.sign();
  find_block_signs(now);
  now.reciprocal_condition = qr_.reciprocal_condition_beside(passive_count_);
  now.is_singular = open_count() > passive_count_;
  now.matrix = matrix_;
  const double by_share = line_.scale / arc.tangent.back();
  for (std::size_t i = 0; i < unknown_.size(); ++i) {
    now.rates[at(unknown_[i])] = by_share * arc.tangent[i];
  }
  for (std::size_t d = 0; d < driven_.size(); ++d) {
    now.rates[at(driven_[d])] = line_.reach[d];
  }
}

template <class Frames>
std::vector<VecX> PathTracker<Frames>::open_directions() {
  std::vector<VecX> result;
  const std::vector<double>& null = qr_.null_vectors();
  for (std::size_t z = 0; z < null.size(); z += unknown_.size()) {
    VecX rates = VecX::Zero(system_.rate_count());
    for (std::size_t i = 0; i < unknown_.size(); ++i) {
      rates[unknown_[i]] = null[z + i];
    }
    result.push_back(rates);
  }
  return result;
}

template class PathTracker<PlanarFrames>;
template class PathTracker<SpatialFrames>;

}  // namespace kinestat
