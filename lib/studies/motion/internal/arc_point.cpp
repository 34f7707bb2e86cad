#include "studies/motion/internal/arc_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// How much the value at place `i` of four counts in the cubic through all of them.
double cubic_weight(std::span<const double> places, std::size_t i, double place) {
  double weight = 1.0;
  for (std::size_t j = 0; j < places.size(); ++j) {
    weight *= j == i ? 1.0 : (place - places[j]) / (places[i] - places[j]);
  }
  return weight;
}

}  // namespace

bool Surroundings::runs_on() const {
  return std::ranges::all_of(points,
                             [](const ArcPoint& point) { return point.tangent.back() > 0.0; });
}

double Surroundings::share_at(double place) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += cubic_weight(places, i, place) * points[i].share;
  }
  return sum;
}

double Surroundings::determinant_at(std::size_t part, double place) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    sum += cubic_weight(places, i, place) * parts[part].determinants[i];
  }
  return sum;
}

double Surroundings::uncertainty(std::size_t part) const {
  const auto& [which, determinants, reciprocal_condition] = parts[part];
  const double bend =
      determinants[3] - 3.0 * determinants[2] + 3.0 * determinants[1] - determinants[0];
  const double length = places[3] - places[0];
  const double slope = (determinants[3] - determinants[0]) / length;
  return std::max(std::abs(bend / slope),
                  kEpsilon * length / (reciprocal_condition * reciprocal_condition));
}

double Crossing::uncertainty() const {
  double worst = 0.0;
  for (const ChangePlace& one : places) {
    worst = std::max(worst, one.uncertainty);
  }
  return worst;
}

ArcPoint Surroundings::point_at(double place) const {
  ArcPoint result = points.front();
  result.share = share_at(place);
  const auto mix = [&](std::vector<double> ArcPoint::*member) {
    std::vector<double>& values = result.*member;
    std::ranges::fill(values, 0.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double weight = cubic_weight(places, i, place);
      for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] += weight * (points[i].*member)[k];
      }
    }
  };
  mix(&ArcPoint::coordinates);
  mix(&ArcPoint::angles);
  mix(&ArcPoint::tangent);
  mix(&ArcPoint::matrix);
  return result;
}

}  // namespace kinestat
