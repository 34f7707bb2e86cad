#include "studies/synthesis/dyads/dyad.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "studies/synthesis/positions/internal/jets.hpp"

namespace kinestat {

namespace {

// A sum that should vanish, and the size of its terms.
struct Balance {
  double sum = 0.0;
  double terms = 0.0;

  void add(double term) {
    sum += term;
    terms += std::abs(term);
  }

  double share() const { return terms > 0.0 ? std::abs(sum) / terms : 0.0; }
};

// Derivative k of the product dot(a, b) of two jets, term by term.
void add_dot_jet(Balance& balance,
                 const std::vector<Point>& a,
                 const std::vector<Point>& b,
                 std::size_t k) {
  for (std::size_t i = 0; i <= k; ++i) {
    const double factor = binomial(k, i);
    balance.add(factor * a[i].real() * b[k - i].real());
    balance.add(factor * a[i].imag() * b[k - i].imag());
  }
}

std::vector<Point> from_centre(std::vector<Point> jets, const Point& centre) {
  jets[0] -= centre;
  return jets;
}

// Two jets whose product is constant: arm * arm of a crank, normal * arm of the sliders.
struct Factors {
  std::vector<Point> one;
  std::vector<Point> other;
};

Factors factors_of(const Dyad& dyad, const PositionJets& position) {
  const std::vector<Point> arm =
      from_centre(point_jets(position, dyad.circle_point), dyad.centre_point);
  std::vector<Point> normal(arm.size(), Point(0.0, 0.0));
  switch (dyad.kind) {
    case DyadKind::crank:
      return {.one = arm, .other = arm};
    case DyadKind::slider:
      normal[0] = left_of(dyad.direction);
      return {.one = normal, .other = arm};
    case DyadKind::inverted_slider:
      normal = rotation_jets(position);
      for (Point& jet : normal) {
        jet *= left_of(dyad.direction);
      }
      return {.one = normal, .other = arm};
  }
  return {};
}

}  // namespace

std::string_view word_of(DyadKind kind) {
  switch (kind) {
    case DyadKind::crank:
      return "crank";
    case DyadKind::slider:
      return "slider";
    case DyadKind::inverted_slider:
      return "inverted_slider";
  }
  return "";
}

std::string_view word_of(DyadPoint which) {
  return which == DyadPoint::circle_point ? "circle_point" : "centre_point";
}

double find_residual(const Dyad& dyad, std::span<const PositionJets> positions) {
  double worst = 0.0;
  const Factors first = factors_of(dyad, positions[0]);
  for (const PositionJets& position : positions) {
    const Factors now = factors_of(dyad, position);
    Balance change;
    add_dot_jet(change, now.one, now.other, 0);
    const double size = change.terms;
    change.add(-dot(first.one[0], first.other[0]));
    // Where both are nearly zero, a line through its point, the arms themselves are the measure.
    const double scale = std::max({change.terms,
                                   size,
                                   std::abs(now.one[0]) * std::abs(now.other[0]),
                                   std::abs(first.one[0]) * std::abs(first.other[0])});
    worst = std::max(worst, scale > 0.0 ? std::abs(change.sum) / scale : 0.0);
    for (std::size_t k = 1; k < now.one.size(); ++k) {
      Balance derivative;
      add_dot_jet(derivative, now.one, now.other, k);
      worst = std::max(worst, derivative.share());
    }
  }
  return worst;
}

void sort_dyads(std::vector<Dyad>& dyads) {
  const auto key = [](const Dyad& dyad) {
    return std::tuple(dyad.kind, dyad.length, dyad.circle_point.real(), dyad.centre_point.real());
  };
  std::ranges::stable_sort(dyads, [&](const Dyad& a, const Dyad& b) { return key(a) < key(b); });
}

}  // namespace kinestat
