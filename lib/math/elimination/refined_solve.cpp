#include "math/elimination/refined_solve.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "math/numbers/internal/unit_roundoff.hpp"
#include "math/tapes/internal/at.hpp"

namespace kinestat {

namespace {

// Sums of what is not negative are themselves rounded: by far less than this for a million terms.
constexpr double kOutwards = 1.0 + 0x1p-20;

// More than what products lose that are too small for the low part of two_product.
constexpr double kLeast = 0x1p-900;

// How often a guess of the bound is enlarged before the matrix counts as possibly singular.
constexpr int kMostGuesses = 4;

// Unknowns up to which an inverse is worth its memory (32 MB) and time.
constexpr std::size_t kLargestInverse = 2000;

// What `map`, which grows with its argument, maps below itself is a bound of everything that is
// below its own image; and so is what it is mapped to.
template <class Map>
std::optional<VecX> find_bound(VecX guess, const Map& map) {
  for (int i = 0; i < kMostGuesses; ++i) {
    VecX mapped = map(guess);
    if (!mapped.allFinite()) {
      return std::nullopt;
    }
    if ((mapped.array() <= guess.array()).all()) {
      return mapped;
    }
    guess = 2.0 * mapped;
  }
  return std::nullopt;
}

}  // namespace

// Three sums, each of what the one before it lost; the last one is rounded, by how much is summed
// too (Ogita, Rump and Oishi, SIAM J. Sci. Comput. 26, 2005, with K = 3).
inline void RefinedSolve::Accumulator::subtract_product(double a, double b) {
  const DoubleDouble product = two_product(a, b);
  const DoubleDouble first = two_sum(sum, -product.high);
  const DoubleDouble second = two_sum(rest, first.low);
  const DoubleDouble third = two_sum(second.high, -product.low);
  const double lost = second.low + third.low;
  sum = first.high;
  rest = third.high;
  tail += lost;
  slack += std::abs(lost) + std::abs(tail);
}

RefinedSolve::RefinedSolve(const Elimination& factors,
                           std::span<const double> known,
                           std::span<const double> rhs)
    : factors_(factors), high_(factors.scaled_known(known)), low_(VecX::Zero(high_.size())) {
  load_entries();
  for (std::size_t r = 0; r < rhs.size(); ++r) {
    right_.push_back(rhs[r] * factors_.scaling_.rows[r]);
  }
  factors_.back_substitute(factors_.eliminate_rows(rhs).values, high_);
  start_residual();
  find_correction();
}

void RefinedSolve::load_entries() {
  const auto row_count = static_cast<std::size_t>(factors_.matrix_.rows);
  std::vector<bool> has_pivot(row_count, false);
  for (const Elimination::Pivot& pivot : factors_.pivots_) {
    at(has_pivot, pivot.row) = true;
  }
  const Scaling& scaling = factors_.scaling_;
  entries_.reserve(factors_.matrix_.entries.size());
  for (const SparseEntry& entry : factors_.matrix_.entries) {
    if (at(has_pivot, entry.row)) {
      const double value =
          entry.value * at(scaling.rows, entry.row) * at(scaling.columns, entry.column);
      entries_.push_back({.row = entry.row, .column = entry.column, .value = value});
    }
  }
  // Each step in a row rounds its product and its difference, relative to the sum of the sizes of
  // all terms; a difference that counts as rounding leaves kCancellation of its two terms.
  const double dropped = factors_.has_dropped_ ? 2.0 * kCancellation : 0.0;
  const double step = 4.0 * kUnitRoundoff + dropped;
  rounding_.assign(row_count, 2.0 * step);
  for (const Elimination::Multiplier& multiplier : factors_.multipliers_) {
    at(rounding_, multiplier.row) += step;
  }
}

// b - A x from nothing.
void RefinedSolve::start_residual() {
  residual_.assign(static_cast<std::size_t>(factors_.matrix_.rows), {});
  for (std::size_t r = 0; r < right_.size(); ++r) {
    residual_[r].sum = right_[r];
  }
  subtract_from_residual(high_);
}

void RefinedSolve::subtract_from_residual(const VecX& x) {
  for (const Entry& entry : entries_) {
    at(residual_, entry.row).subtract_product(entry.value, x[entry.column]);
  }
}

void RefinedSolve::find_correction() {
  VecX right(static_cast<Eigen::Index>(residual_.size()));
  for (std::size_t r = 0; r < residual_.size(); ++r) {
    right[static_cast<Eigen::Index>(r)] = residual_[r].sum + residual_[r].rest + residual_[r].tail;
  }
  correction_ = solve(std::move(right));
}

// The first correction is added without error, so that its residual continues the one before.
void RefinedSolve::refine() {
  const bool is_first = low_.isZero(0.0);
  for (Eigen::Index c = 0; c < high_.size(); ++c) {
    const DoubleDouble sum = DoubleDouble{.high = high_[c], .low = low_[c]} +
                             DoubleDouble{.high = correction_[c], .low = 0.0};
    high_[c] = sum.high;
    low_[c] = sum.low;
  }
  if (is_first) {
    subtract_from_residual(correction_);
  } else {
    start_residual();
    subtract_from_residual(low_);
  }
  find_correction();
}

// (LU)⁻¹ right, plainly; zero outside the columns of the pivots.
VecX RefinedSolve::solve(VecX right) const {
  for (const Elimination::Multiplier& step : factors_.multipliers_) {
    right[step.row] -= step.value * right[step.pivot_row];
  }
  VecX x = VecX::Zero(factors_.matrix_.columns);
  const auto& pivots = factors_.pivots_;
  for (auto pivot = pivots.rbegin(); pivot != pivots.rend(); ++pivot) {
    double sum = right[pivot->row];
    for (const Elimination::Cell& cell : at(factors_.rows_, pivot->row)) {
      sum -= cell.value * x[cell.column];
    }
    x[pivot->column] = sum / pivot->value;
  }
  return x;
}

// At least |(LU)⁻¹| right, for what is not negative.
VecX RefinedSolve::majorant(VecX right) const {
  for (const Elimination::Multiplier& step : factors_.multipliers_) {
    right[step.row] += std::abs(step.value) * right[step.pivot_row];
  }
  VecX x = VecX::Zero(factors_.matrix_.columns);
  const auto& pivots = factors_.pivots_;
  for (auto pivot = pivots.rbegin(); pivot != pivots.rend(); ++pivot) {
    double sum = right[pivot->row];
    for (const Elimination::Cell& cell : at(factors_.rows_, pivot->row)) {
      sum += std::abs(cell.value) * x[cell.column];
    }
    x[pivot->column] = kOutwards * sum / std::abs(pivot->value);
  }
  return x;
}

// At least |b - A (x + d)|: the difference in double, and what its terms may have lost.
VecX RefinedSolve::left_over() const {
  const auto count = static_cast<Eigen::Index>(residual_.size());
  VecX left(count);
  VecX size(count);
  for (Eigen::Index r = 0; r < count; ++r) {
    const Accumulator& residual = residual_[static_cast<std::size_t>(r)];
    const double sum = residual.sum + residual.rest;
    left[r] = sum + residual.tail;
    size[r] = std::abs(sum) + std::abs(left[r]) + residual.slack;
  }
  for (const Entry& entry : entries_) {
    const double term = entry.value * correction_[entry.column];
    left[entry.row] -= term;
    size[entry.row] += std::abs(term) + std::abs(left[entry.row]);
  }
  return ((left.cwiseAbs() + kUnitRoundoff * size) * kOutwards).array() + kLeast;
}

// At least |A - LU| x for what is not negative. Entries at the same place were rounded when they
// were added.
VecX RefinedSolve::rounding_of_factors(const VecX& x) const {
  VecX upper = VecX::Zero(factors_.matrix_.rows);
  for (const Elimination::Pivot& pivot : factors_.pivots_) {
    for (const Elimination::Cell& cell : at(factors_.rows_, pivot.row)) {
      upper[pivot.row] += std::abs(cell.value) * x[cell.column];
    }
  }
  VecX both = upper;
  for (const Elimination::Multiplier& step : factors_.multipliers_) {
    both[step.row] += std::abs(step.value) * upper[step.pivot_row];
  }
  for (const Entry& entry : entries_) {
    both[entry.row] += std::abs(entry.value) * x[entry.column];
  }
  for (Eigen::Index r = 0; r < both.size(); ++r) {
    both[r] *= rounding_[static_cast<std::size_t>(r)];
  }
  return both;
}

std::optional<VecX> RefinedSolve::error_bound() const {
  const VecX left = left_over();
  if (!left.allFinite()) {
    return std::nullopt;
  }
  std::optional<VecX> bound = bound_by_factors(left);
  if (!bound && factors_.pivots_.size() <= kLargestInverse) {
    bound = bound_by_inverse(left);
  }
  if (!bound) {
    return std::nullopt;
  }
  const bool is_nothing_known =
      high_.isZero(0.0) && std::ranges::all_of(right_, [](double x) { return x == 0.0; });
  if (is_nothing_known) {
    return VecX::Zero(high_.size());  // what solves a regular system exactly
  }
  *bound = kOutwards * (correction_.cwiseAbs() + *bound);
  VecX in_units = high_;
  factors_.unscale(*bound);
  factors_.unscale(in_units);
  return bound->allFinite() && in_units.allFinite() ? bound : std::nullopt;
}

// With E = A - LU, the error e of x + d obeys |e| <= |(LU)⁻¹| (left + |E| |e|).
std::optional<VecX> RefinedSolve::bound_by_factors(const VecX& left) const {
  return find_bound(2.0 * majorant(left),
                    [&](const VecX& e) { return majorant(left + rounding_of_factors(e)); });
}

// With any X, best an inverse of A, |e| <= |X| left + |I - X A| |e|.
std::optional<VecX> RefinedSolve::bound_by_inverse(const VecX& left) const {
  const auto columns = static_cast<Eigen::Index>(factors_.matrix_.columns);
  MatX inverse = MatX::Zero(columns, left.size());
  MatX rest = MatX::Zero(columns, columns);
  for (const Elimination::Pivot& pivot : factors_.pivots_) {
    inverse.col(pivot.row) = solve(VecX::Unit(left.size(), pivot.row));
    rest(pivot.column, pivot.column) = 1.0;
  }
  MatX size = rest;
  VecX count = VecX::Constant(columns, 2.0);
  for (const Entry& entry : entries_) {
    rest.col(entry.column) -= entry.value * inverse.col(entry.row);
    size.col(entry.column) += std::abs(entry.value) * inverse.col(entry.row).cwiseAbs();
    count[entry.column] += 2.0;
  }
  const MatX map = kOutwards * (rest.cwiseAbs() + kUnitRoundoff * size * count.asDiagonal());
  const VecX start = kOutwards * (inverse.cwiseAbs() * left);
  return find_bound(2.0 * start, [&](const VecX& e) -> VecX { return start + map * e; });
}

std::vector<DoubleDouble> RefinedSolve::x() const {
  std::vector<DoubleDouble> result;
  for (Eigen::Index c = 0; c < high_.size(); ++c) {
    const double unit = factors_.scaling_.columns[static_cast<std::size_t>(c)];
    result.push_back({.high = unit * high_[c], .low = unit * low_[c]});
  }
  return result;
}

}  // namespace kinestat
