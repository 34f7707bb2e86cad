#include "studies/motion/hermite_cubic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// A cubic to this share of its size by the fourth power of the stretch: of harmonics up to the
// third.
constexpr double kCubicError = 0.3;
constexpr int kCubicParts = 16;

// A cubic that falls by less than so many of its errors along a stretch may as well rise.
constexpr double kFlatSlope = 8.0;

// The largest of t (1 - t)², by which a slope at one end moves a cubic.
constexpr double kMostBySlope = 4.0 / 27.0;

constexpr int kMostZeroTrials = 40;

}  // namespace

double HermiteCubic::at(double t) const {
  const double s = 1.0 - t;
  return s * s * ((1.0 + 2.0 * t) * low + t * low_slope) +
         t * t * ((1.0 + 2.0 * s) * high - s * high_slope);
}

double HermiteCubic::slope_at(double t) const {
  const double s = 1.0 - t;
  return 6.0 * s * t * (high - low) + s * (s - 2.0 * t) * low_slope +
         t * (t - 2.0 * s) * high_slope;
}

// A fourth derivative adds a multiple of t² (1 - t)²: a sixteenth of it at most, a thirtieth in the
// mean.
double HermiteCubic::error_by_mean(double mean) const {
  const double own = 0.5 * (low + high) + (low_slope - high_slope) / 12.0;
  return 30.0 / 16.0 * std::abs(mean - own);
}

double HermiteCubic::error(double stretch) const {
  const double square = stretch * stretch;
  return kCubicError * square * stretch *
         (stretch * std::max(std::abs(low), std::abs(high)) + std::abs(low_slope) +
          std::abs(high_slope));
}

std::optional<double> HermiteCubic::doubtful_part(double error) const {
  if (is_told_by_ends(error)) {
    return std::nullopt;
  }
  if ((low < 0.0) != (high < 0.0)) {
    return 0.5;
  }
  const double sense = low < 0.0 ? -1.0 : 1.0;
  const auto part_of = [](int k) { return static_cast<double>(k) / kCubicParts; };
  int lowest = 0;
  for (int k = 1; k <= kCubicParts; ++k) {
    lowest = sense * at(part_of(k)) < sense * at(part_of(lowest)) ? k : lowest;
  }
  // From an end it falls within the next part, or may.
  const double aside = lowest == 0 ? 0.5 : lowest == kCubicParts ? -0.5 : 0.0;
  return (lowest + aside) / kCubicParts;
}

// Cut where its slope is zero or begins to be clear: between cuts it rises or falls clearly, and is
// zero once if its sign changes, or may turn back, and then must be farther from zero than `error`.
bool HermiteCubic::is_told_by_ends(double error) const {
  if (is_clear_of_zero(error)) {
    return true;
  }
  const double flat = kFlatSlope * error;
  const double curve = 2.0 * (low_slope + high_slope) - 4.0 * slope_at(0.5);  // of the slope
  const double start = high_slope - low_slope - curve;
  std::array<double, 8> cuts = {0.0, 1.0};
  std::size_t count = 2;
  const auto add = [&](double t) {
    if (t > 0.0 && t < 1.0) {
      cuts[count++] = t;
    }
  };
  for (const double slope : {-flat, 0.0, flat}) {
    const double rest = low_slope - slope;
    const double square = start * start - 4.0 * curve * rest;
    if (square >= 0.0) {
      const double sum = -0.5 * (start + std::copysign(std::sqrt(square), start));
      add(sum / curve);
      add(rest / sum);
    }
  }
  std::sort(cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(count));
  int changes = 0;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double before = at(cuts[i]);
    const double after = at(cuts[i + 1]);
    const bool is_change = (before < 0.0) != (after < 0.0);
    const bool is_flat = !(std::abs(slope_at(0.5 * (cuts[i] + cuts[i + 1]))) > flat);
    if (is_flat && (is_change || !(std::min(std::abs(before), std::abs(after)) > error))) {
      return false;
    }
    changes += is_change ? 1 : 0;
  }
  return changes == ((low < 0.0) != (high < 0.0) ? 1 : 0);
}

bool HermiteCubic::is_clear_at_low(double error) const {
  return std::abs(low_slope) > kFlatSlope * error;
}

bool HermiteCubic::is_clear_at_high(double error) const {
  return std::abs(high_slope) > kFlatSlope * error;
}

// By Newton's steps, halving where they leave the bracket.
double HermiteCubic::zero() const {
  double before = 0.0;
  double behind = 1.0;
  double t = low / (low - high);
  for (int i = 0; i < kMostZeroTrials; ++i) {
    const double value = at(t);
    (std::signbit(value) == std::signbit(low) ? before : behind) = t;
    const double next = t - value / slope_at(t);
    const bool is_within = next >= before && next <= behind;
    const double last = t;
    t = is_within ? next : 0.5 * (before + behind);
    if (std::abs(t - last) <= kEpsilon * t) {
      break;
    }
  }
  return t;
}

// Both ends too far off for their slopes to bring it there.
bool HermiteCubic::is_clear_of_zero(double error) const {
  return (low < 0.0) == (high < 0.0) &&
         std::min(std::abs(low), std::abs(high)) >
             kMostBySlope * (std::abs(low_slope) + std::abs(high_slope)) + error;
}

}  // namespace kinestat
