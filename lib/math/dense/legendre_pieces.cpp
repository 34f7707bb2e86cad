#include "math/dense/legendre_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

constexpr int kPointCount = 12;

// After so many successive halvings that leave both halves as rough as the whole, roughness is
// noise: at a jump only one half stays rough. Counted once pieces are too narrow for the range to
// be filled.
constexpr int kRoughHalves = 4;

// P_0 to P_(count - 1) at a place of [-1, 1].
VecX legendre_values(double x, int count) {
  VecX values(count);
  values[0] = 1.0;
  if (count > 1) {
    values[1] = x;
  }
  for (int k = 2; k < count; ++k) {
    values[k] = ((2.0 * k - 1.0) * x * values[k - 1] - (k - 1.0) * values[k - 2]) / k;
  }
  return values;
}

// The integrals of the same from -1: (P_(k+1) - P_(k-1)) / (2 k + 1).
VecX legendre_integrals(double x, int count) {
  const VecX values = legendre_values(x, count + 1);
  VecX integrals(count);
  integrals[0] = x + 1.0;
  for (int k = 1; k < count; ++k) {
    integrals[k] = (values[k + 1] - values[k - 1]) / (2.0 * k + 1.0);
  }
  return integrals;
}

const GaussPoints& rule() {
  static const GaussPoints points = gauss_points(kPointCount);
  return points;
}

// From values at the points of Gauss to coefficients.
const MatX& to_coefficients() {
  static const MatX matrix = [] {
    MatX result(kPointCount, kPointCount);
    for (int i = 0; i < kPointCount; ++i) {
      const VecX values = legendre_values(rule().points[i], kPointCount);
      for (int k = 0; k < kPointCount; ++k) {
        result(k, i) = (k + 0.5) * rule().weights[i] * values[k];
      }
    }
    return result;
  }();
  return matrix;
}

double place_in(const LegendrePieces::Piece& piece, double argument) {
  const double x = (2.0 * argument - piece.from - piece.to) / (piece.to - piece.from);
  return std::clamp(x, -1.0, 1.0);
}

double argument_in(const LegendrePieces::Piece& piece, double x) {
  return 0.5 * (piece.from + piece.to) + 0.5 * (piece.to - piece.from) * x;
}

class PieceFinder {
 public:
  PieceFinder(const FunctionsAt& functions,
              std::span<const double> places,
              const LegendrePieces::Limits& limits)
      : functions_(functions), places_(places), limits_(limits) {}

  // Empty where there are none.
  std::vector<LegendrePieces::Piece> run(VecX& sizes) {
    std::vector<Half> waiting;
    for (std::size_t i = places_.size() - 1; i > 0; --i) {
      auto piece = look(places_[i - 1], places_[i]);
      if (!piece) {
        return {};
      }
      waiting.push_back({.piece = *std::move(piece)});
    }
    std::vector<LegendrePieces::Piece> found;
    const double range = std::abs(places_.back() - places_.front());
    while (!waiting.empty()) {
      Half half = std::move(waiting.back());
      waiting.pop_back();
      LegendrePieces::Piece& piece = half.piece;
      piece.tail = tail_of(piece);
      const double width = piece.to - piece.from;
      if (width <= limits_.finest * range || is_fine(piece.tail, half.whole)) {
        found.push_back(std::move(piece));
        continue;
      }
      const double middle = 0.5 * (piece.from + piece.to);
      auto low = look(piece.from, middle);
      auto high = look(middle, piece.to);
      if (!low || !high || found.size() + waiting.size() + 2 > limits_.most) {
        return {};
      }
      const bool are_rough = width * static_cast<double>(limits_.most) < range &&
                             is_rough(*low, piece.tail) && is_rough(*high, piece.tail);
      const int rough = are_rough ? half.rough + 1 : 0;
      if (rough >= kRoughHalves) {
        return {};
      }
      waiting.push_back({.piece = *std::move(high), .whole = piece.tail, .rough = rough});
      waiting.push_back({.piece = *std::move(low), .whole = piece.tail, .rough = rough});
    }
    sizes = sizes_;
    return found;
  }

 private:
  struct Half {
    LegendrePieces::Piece piece;
    double whole = std::numeric_limits<double>::infinity();  // tail of the piece of which it is one
    int rough = 0;  // of how many pieces around it both halves are about as rough as the whole
  };

  std::optional<LegendrePieces::Piece> look(double from, double to) {
    LegendrePieces::Piece piece{.from = from, .to = to, .values = {}, .coefficients = {}};
    for (int i = 0; i < kPointCount; ++i) {
      const auto there = functions_(argument_in(piece, rule().points[i]));
      if (!there) {
        return std::nullopt;
      }
      if (piece.values.size() == 0) {
        piece.values.resize(kPointCount, there->values.size());
      }
      piece.values.row(i) = there->values.transpose();
      sizes_ = sizes_.size() == 0 ? there->sizes : VecX(sizes_.cwiseMax(there->sizes));
    }
    piece.coefficients = to_coefficients() * piece.values;
    return piece;
  }

  // The last two terms of a piece as a share of the size that its function has had so far, for the
  // function where this is largest.
  double tail_of(const LegendrePieces::Piece& piece) const {
    const auto tail = piece.coefficients.bottomRows(2).cwiseAbs().colwise().sum();
    double largest = 0.0;
    for (Eigen::Index f = 0; f < tail.size(); ++f) {
      if (tail[f] > 0.0) {
        largest = std::max(largest, tail[f] / sizes_[f]);
      }
    }
    return largest;
  }

  bool is_fine(double tail, double whole) const {
    return tail <= limits_.tail || (tail <= limits_.noise && tail >= 0.5 * whole);
  }

  // A jump is in one half of a piece, and what is rounding in both; the terms of what is smooth are
  // a thousand times smaller in a half.
  bool is_rough(const LegendrePieces::Piece& half, double whole) const {
    const double tail = tail_of(half);
    return tail > limits_.noise && tail >= 0.1 * whole;
  }

  const FunctionsAt& functions_;
  std::span<const double> places_;
  const LegendrePieces::Limits& limits_;
  VecX sizes_;
};

// By sections of the golden ratio, until the bracket is that narrow.
GreatestValue climb(const std::function<double(double)>& value,
                    double low,
                    double high,
                    double least) {
  const double ratio = 1.0 / std::numbers::phi;
  double left = high - ratio * (high - low);
  double right = low + ratio * (high - low);
  double at_left = value(left);
  double at_right = value(right);
  while (high - low > least) {
    if (at_left >= at_right) {
      high = std::exchange(right, left);
      at_right = at_left;
      left = high - ratio * (high - low);
      at_left = value(left);
    } else {
      low = std::exchange(left, right);
      at_left = at_right;
      right = low + ratio * (high - low);
      at_right = value(right);
    }
  }
  return at_left >= at_right ? GreatestValue{.value = at_left, .argument = left}
                             : GreatestValue{.value = at_right, .argument = right};
}

// By values alone a place is known to half of the digits; through three of them, the cube root of
// rounding apart, goes a parabola whose vertex is known to two thirds. Of a corner it is no better.
GreatestValue at_vertex(const std::function<double(double)>& value,
                        const GreatestValue& top,
                        double low,
                        double high) {
  const double step = std::cbrt(kEpsilon) * (high - low);
  if (top.argument - low < step || high - top.argument < step) {
    return top;
  }
  const double before = value(top.argument - step);
  const double behind = value(top.argument + step);
  const double bend = before - 2.0 * top.value + behind;
  const double shift = 0.5 * step * (before - behind) / bend;
  if (!(bend < 0.0) || !(std::abs(shift) < step)) {
    return top;
  }
  const double there = value(top.argument + shift);
  return there >= top.value - kCancellation * std::abs(top.value)
             ? GreatestValue{.value = std::max(there, top.value), .argument = top.argument + shift}
             : top;
}

}  // namespace

// The points by Newton's method from the estimate of Tricomi.
GaussPoints gauss_points(int count) {
  GaussPoints rule{.points = VecX(count), .weights = VecX(count)};
  for (int i = 0; i < count; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
    double slope = 0.0;
    for (int round = 0; round < 100; ++round) {
      const VecX values = legendre_values(x, count + 1);
      slope = count * (values[count - 1] - x * values[count]) / (1.0 - x * x);
      const double step = values[count] / slope;
      x -= step;
      if (std::abs(step) <= kEpsilon) {
        break;
      }
    }
    rule.points[i] = x;
    rule.weights[i] = 2.0 / ((1.0 - x * x) * slope * slope);
  }
  return rule;
}

std::optional<LegendrePieces> LegendrePieces::find(const FunctionsAt& functions,
                                                   std::span<const double> places,
                                                   const Limits& limits) {
  LegendrePieces result;
  result.pieces_ = PieceFinder(functions, places, limits).run(result.sizes_);
  if (result.pieces_.empty()) {
    return std::nullopt;
  }
  VecX sum = VecX::Zero(result.sizes_.size());
  for (const Piece& piece : result.pieces_) {
    result.begun_.push_back(sum);
    sum += (piece.to - piece.from) * piece.coefficients.row(0).transpose();
  }
  return result;
}

const LegendrePieces::Piece& LegendrePieces::piece_at(double argument) const {
  const auto behind = std::ranges::upper_bound(pieces_, argument, {}, &Piece::from);
  return behind == pieces_.begin() ? pieces_.front() : *(behind - 1);
}

double LegendrePieces::value(std::size_t function, double argument) const {
  const Piece& piece = piece_at(argument);
  return piece.coefficients.col(static_cast<Eigen::Index>(function))
      .dot(legendre_values(place_in(piece, argument), kPointCount));
}

VecX LegendrePieces::values(double argument) const {
  const Piece& piece = piece_at(argument);
  return piece.coefficients.transpose() * legendre_values(place_in(piece, argument), kPointCount);
}

double LegendrePieces::integral(std::size_t function, double argument) const {
  const Piece& piece = piece_at(argument);
  const auto f = static_cast<Eigen::Index>(function);
  return begun_[static_cast<std::size_t>(&piece - pieces_.data())][f] +
         0.5 * (piece.to - piece.from) *
             piece.coefficients.col(f).dot(
                 legendre_integrals(place_in(piece, argument), kPointCount));
}

void LegendrePieces::for_each_point(double widest, const AtPoint& take) const {
  for (const Piece& piece : pieces_) {
    const int parts = std::max(1, static_cast<int>(std::ceil((piece.to - piece.from) / widest)));
    const double width = (piece.to - piece.from) / parts;
    for (int p = 0; p < parts; ++p) {
      const double middle = piece.from + (p + 0.5) * width;
      for (int i = 0; i < kPointCount; ++i) {
        const double argument = middle + 0.5 * width * rule().points[i];
        take(argument,
             0.5 * width * rule().weights[i],
             piece.coefficients.transpose() *
                 legendre_values(place_in(piece, argument), kPointCount));
      }
    }
  }
}

GreatestValue LegendrePieces::greatest(const std::function<double(double argument)>& value) const {
  std::vector<double> places = {from()};
  for (const Piece& piece : pieces_) {
    for (int i = 0; i < kPointCount; ++i) {
      places.push_back(argument_in(piece, rule().points[i]));
    }
  }
  places.push_back(to());
  std::vector<double> heights;
  heights.reserve(places.size());
  for (const double place : places) {
    heights.push_back(value(place));
  }
  const double top = std::abs(*std::ranges::max_element(heights));
  std::vector<GreatestValue> peaks;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t behind = std::min(i + 1, places.size() - 1);
    const double flat = kSameValue * top;
    if (heights[i] + flat < heights[before] || heights[i] + flat < heights[behind]) {
      continue;
    }
    peaks.push_back({.value = heights[i], .argument = places[i]});
    if (heights[i] > heights[before] + flat || heights[i] > heights[behind] + flat) {
      const GreatestValue there =
          climb(value, places[before], places[behind], kCancellation * (to() - from()));
      peaks.back() = there.value > heights[i] ? there : peaks.back();
    }
  }
  const double best = std::ranges::max_element(peaks, {}, &GreatestValue::value)->value;
  // Peaks that only what the polynomials leave tells apart are equal.
  const auto first = std::ranges::find_if(
      peaks, [&](const GreatestValue& one) { return one.value >= best - kCycleNoise * top; });
  const GreatestValue found = at_vertex(value, *first, from(), to());
  return {.value = std::max(found.value, best), .argument = found.argument};
}

}  // namespace kinestat
