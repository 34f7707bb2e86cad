#include "motion/internal/path_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/tolerance.hpp"
#include "motion/internal/motion_limits.hpp"

namespace kinestat {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

double largest(std::span<const double> values) {
  double result = 0.0;
  for (const double value : values) {
    result = std::max(result, std::abs(value));
  }
  return result;
}

// How much the value at place `i` of four counts in the cubic through all of them.
double cubic_weight(std::span<const double> places, std::size_t i, double place) {
  double weight = 1.0;
  for (std::size_t j = 0; j < places.size(); ++j) {
    weight *= j == i ? 1.0 : (place - places[j]) / (places[i] - places[j]);
  }
  return weight;
}

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
PathTracker<Frames>::PathTracker(const MotionNetwork& network)
    : system_(network),
      driven_(network.driven_rates),
      passive_count_(static_cast<int>(network.passive_motions.size())),
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
  is_square_ = system_.row_count() == static_cast<int>(unknown_.size());
  from_.assign(driven_.size(), 0.0);
  reach_.assign(driven_.size(), 0.0);
  const std::size_t rates = at(network.rate_count);
  const std::size_t rows = at(system_.row_count());
  right_.resize(rows + 1);
  solved_.resize(rates + 1);
  step_.resize(rates);
  correction_.resize(rates);
  matrix_.resize(rows * unknown_.size());
  trial_ = make_point();
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
  scale_ = 0.0;
  for (std::size_t d = 0; d < driven_.size(); ++d) {
    from_[d] = from[d];
    reach_[d] = to[d] - from[d];
    scale_ = std::max(scale_, std::abs(reach_[d]));
  }
  scale_ = scale_ > 0.0 ? scale_ : 1.0;
}

template <class Frames>
void PathTracker<Frames>::set_drives(double share, std::span<double> coordinates) const {
  for (std::size_t d = 0; d < driven_.size(); ++d) {
    coordinates[at(drive_coordinates_[d])] = from_[d] + share * reach_[d];
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

template <class Frames>
bool PathTracker<Frames>::close(PathPoint& point, double& moved) {
  const int columns = static_cast<int>(unknown_.size());
  const int rows = system_.row_count();
  moved = 0.0;
  double last = kFarCorrection;
  bool is_last = false;
  for (int round = 0; round < kMostRounds; ++round) {
    system_.evaluate(point.coordinates, point.angles);
    point.misclosure = system_.largest_residual();
    gather(unknown_, matrix_);
    qr_.factor(matrix_, rows, columns);
    if (point.misclosure <= kMotionClosure || is_last) {
      break;
    }
    if (!std::isfinite(point.misclosure)) {
      return false;
    }
    std::ranges::transform(
        system_.residuals(), right_.begin(), [](double residual) { return -residual; });
    qr_.solve(right_, solved_);
    const double size = largest(std::span(solved_).first(unknown_.size()));
    if (size > last) {
      return false;
    }
    is_last = size <= kLeastCorrection;
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
  }
  point.sign = qr_.sign();
  point.flatness = qr_.flatness();
  if (!(point.misclosure <= kAcceptedMisclosure)) {
    return false;
  }
  system_.follow_angles(point.angles);
  return true;
}

template <class Frames>
void PathTracker<Frames>::find_rates(PathPoint& point) {
  const int rows = system_.row_count();
  std::ranges::fill(right_, 0.0);
  for (std::size_t d = 0; d < driven_.size(); ++d) {
    const double* column = system_.jacobian().data() + driven_[d] * rows;
    for (int r = 0; r < rows; ++r) {
      right_[at(r)] -= column[r] * reach_[d];
    }
    point.rates[at(driven_[d])] = reach_[d];
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
  return worst / scale_;
}

// Cubic through the last two points and their rates.
template <class Frames>
void PathTracker<Frames>::predict(const PathPoint& now, const PathPoint& before, double step) {
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
  if (next.is_singular || next.flatness < kFlatClosure || next.sign != now.sign ||
      moved > kMostCorrection * largest(next.arrival)) {
    return false;
  }
  double change = 0.0;
  for (std::size_t i = 0; i < now.rates.size(); ++i) {
    change = std::max(change, std::abs(next.rates[i] - now.rates[i]));
  }
  if (!is_square_ &&
      orientation(now.matrix, next.matrix, static_cast<int>(unknown_.size())) < 0.0) {
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
  if (largest(step_) > kLongestStep ||
      (follows_turns_ && system_.total_turn(step_) > kMostTurnInStep)) {
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
  find_rates(next);
  return keeps_branch(now, next, moved);
}

template <class Frames>
Arrival PathTracker<Frames>::advance(PathPoint& now, PathPoint& before, double share) {
  double step = share - now.share;
  const double least = kFinestShare * step;
  while (now.share < share) {
    const double next = now.share + step >= share - least ? share : now.share + step;
    if (!now.is_singular && try_step(now, before, next, trial_)) {
      std::swap(before, now);
      std::swap(now, trial_);
      step *= 2.0;
      continue;
    }
    step *= 0.5;
    if (step > least && !now.is_singular) {
      continue;
    }
    const Arrival arrival = walk_arc(now, share);
    now.arrival_share = 0.0;
    return arrival;
  }
  return Arrival::reached;
}

template <class Frames>
typename PathTracker<Frames>::ArcPoint PathTracker<Frames>::arc_point(const PathPoint& now) {
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

// Newton in the plane across the tangent.
template <class Frames>
bool PathTracker<Frames>::correct_arc(const ArcPoint& from, double length, ArcPoint& to) {
  const std::size_t columns = unknown_.size() + 1;
  const int rows = system_.row_count();
  to.share = from.share;
  to.coordinates = from.coordinates;
  to.angles = from.angles;
  std::vector<double> move(columns);
  std::vector<double> corrected(columns, 0.0);
  const auto apply = [&](std::span<const double> by) {
    std::ranges::fill(correction_, 0.0);
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      correction_[at(unknown_[i])] = by[i];
    }
    to.share += by[columns - 1] / scale_;
    system_.move(correction_, to.coordinates);
    set_drives(to.share, to.coordinates);
  };
  for (std::size_t i = 0; i < columns; ++i) {
    move[i] = length * from.tangent[i];
  }
  apply(move);
  if (follows_turns_ && system_.total_turn(correction_) > kMostTurnInStep) {
    return false;
  }
  bool is_closed = false;
  for (int round = 0; round < kMostRounds; ++round) {
    system_.evaluate(to.coordinates, to.angles);
    const double missed = system_.largest_residual();
    if (!std::isfinite(missed)) {
      return false;
    }
    is_closed = missed <= kAcceptedMisclosure;
    if (missed <= kMotionClosure) {
      break;
    }
    augmented_matrix(to.matrix);
    augmented_.resize(at(rows + 1) * columns);
    for (std::size_t c = 0; c < columns; ++c) {
      std::copy_n(to.matrix.data() + c * at(rows), rows, augmented_.data() + c * at(rows + 1));
      augmented_[c * at(rows + 1) + at(rows)] = from.tangent[c];
    }
    qr_.factor(augmented_, rows + 1, static_cast<int>(columns));
    std::ranges::transform(
        system_.residuals(), right_.begin(), [](double residual) { return -residual; });
    right_[at(rows)] =
        -std::inner_product(corrected.begin(), corrected.end(), from.tangent.begin(), 0.0);
    qr_.solve(right_, solved_);
    const std::span<const double> by = std::span(solved_).first(columns);
    for (std::size_t i = 0; i < columns; ++i) {
      corrected[i] += by[i];
    }
    if (largest(corrected) > kMostArcCorrection * std::abs(length)) {
      return false;
    }
    apply(by);
    if (largest(by) <= kLeastCorrection) {
      system_.evaluate(to.coordinates, to.angles);
      break;
    }
  }
  if (!is_closed) {
    return false;
  }
  system_.follow_angles(to.angles);
  augmented_matrix(to.matrix);
  return find_tangent(from.tangent, to);
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

// +1 where no singular position lies between two near ones, -1 where one does: the sign of
// det(aᵀ b + Σ z zᵀ), z the null vectors of a, which is that of det a · det b where both are
// square.
template <class Frames>
double PathTracker<Frames>::orientation(const std::vector<double>& a,
                                        const std::vector<double>& b,
                                        int columns) {
  const int rows = static_cast<int>(a.size()) / columns;
  qr_.factor(a, rows, columns);
  const std::vector<double> null = qr_.null_vectors();
  std::vector<double> product(at(columns * columns), 0.0);
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < columns; ++j) {
      double sum = 0.0;
      for (int r = 0; r < rows; ++r) {
        sum += a[at(i * rows + r)] * b[at(j * rows + r)];
      }
      for (std::size_t z = 0; z < null.size(); z += at(columns)) {
        sum += null[z + at(i)] * null[z + at(j)];
      }
      product[at(j * columns + i)] = sum;
    }
  }
  qr_.factor(product, columns, columns);
  return qr_.sign();
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

// `now` becomes the point of the arc.
template <class Frames>
void PathTracker<Frames>::land(const ArcPoint& arc, PathPoint& now) {
  now.share = arc.share;
  now.coordinates = arc.coordinates;
  now.angles = arc.angles;
  system_.evaluate(now.coordinates, now.angles);
  now.misclosure = system_.largest_residual();
  gather(unknown_, matrix_);
  qr_.factor(matrix_, system_.row_count(), static_cast<int>(unknown_.size()));
  now.sign = qr_.sign();
  now.flatness = qr_.flatness();
  now.is_singular = open_count() > passive_count_;
  now.matrix = matrix_;
  const double by_share = scale_ / arc.tangent.back();
  for (std::size_t i = 0; i < unknown_.size(); ++i) {
    now.rates[at(unknown_[i])] = by_share * arc.tangent[i];
  }
  for (std::size_t d = 0; d < driven_.size(); ++d) {
    now.rates[at(driven_[d])] = reach_[d];
  }
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
    there = between(*around, low);
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
  note_special(SpecialKind::change_point, between(*around, low), kChangePointBracket);
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

template <class Frames>
std::optional<typename PathTracker<Frames>::Surroundings> PathTracker<Frames>::surround(
    const ArcPoint& from, double place) {
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

template <class Frames>
double PathTracker<Frames>::Surroundings::share_at(double place) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += cubic_weight(places, i, place) * points[i].share;
  }
  return sum;
}

template <class Frames>
double PathTracker<Frames>::Surroundings::determinant_at(double place) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < determinants.size(); ++i) {
    sum += cubic_weight(places, i, place) * determinants[i];
  }
  return sum;
}

template <class Frames>
typename PathTracker<Frames>::ArcPoint PathTracker<Frames>::between(const Surroundings& around,
                                                                    double place) const {
  ArcPoint result = around.points.front();
  result.share = around.share_at(place);
  const auto mix = [&](std::vector<double> ArcPoint::*member) {
    std::vector<double>& values = result.*member;
    std::ranges::fill(values, 0.0);
    for (std::size_t i = 0; i < around.points.size(); ++i) {
      const double weight = cubic_weight(around.places, i, place);
      for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] += weight * (around.points[i].*member)[k];
      }
    }
  };
  mix(&ArcPoint::coordinates);
  mix(&ArcPoint::angles);
  mix(&ArcPoint::tangent);
  mix(&ArcPoint::matrix);
  return result;
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

// Levenberg and Marquardt: the step is held back while it does not bring the ends together.
template <class Frames>
void PathTracker<Frames>::find_nearest(PathPoint& point, bool moves_drives) {
  std::vector<int> columns = unknown_;
  if (moves_drives) {
    columns.insert(columns.end(), driven_.begin(), driven_.end());
  }
  const int rows = system_.row_count();
  const int count = static_cast<int>(columns.size());
  const auto missed = [&](const std::vector<double>& residuals) {
    return std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
  };
  double damping = kFirstDamping;
  system_.evaluate(point.coordinates, point.angles);
  double now = missed(system_.residuals());
  std::vector<double> matrix;
  for (int round = 0; round < kMostNearestRounds && damping < kMostDamping; ++round) {
    gather(columns, matrix);
    std::vector<double> damped(at((rows + count) * count), 0.0);
    std::vector<double> right(at(rows + count), 0.0);
    for (int c = 0; c < count; ++c) {
      std::copy_n(matrix.data() + c * rows, rows, damped.data() + c * (rows + count));
      damped[at(c * (rows + count) + rows + c)] = std::sqrt(damping);
    }
    std::ranges::transform(
        system_.residuals(), right.begin(), [](double residual) { return -residual; });
    qr_.factor(damped, rows + count, count);
    std::vector<double> by(at(count));
    qr_.solve(right, by);
    std::ranges::fill(correction_, 0.0);
    for (int c = 0; c < count; ++c) {
      correction_[at(columns[at(c)])] = by[at(c)];
    }
    std::vector<double> next = point.coordinates;
    system_.move(correction_, next);
    system_.evaluate(next, point.angles);
    const double then = missed(system_.residuals());
    if (then <= now) {
      point.coordinates = std::move(next);
      system_.follow_angles(point.angles);
      damping *= 0.1;
      now = then;
      if (largest(by) <= kLeastCorrection) {
        break;
      }
    } else {
      damping *= 10.0;
      system_.evaluate(point.coordinates, point.angles);
    }
  }
  point.misclosure = system_.largest_residual();
}

template class PathTracker<PlanarFrames>;
template class PathTracker<SpatialFrames>;

}  // namespace kinestat
