// Derivatives by the angle of the plane from those by another parameter; for any type of number.
#pragma once

#include <cstddef>
#include <vector>

#include "studies/synthesis/positions/internal/jets.hpp"

namespace kinestat {

/// The derivatives of (df/dt) / γ' by t from those of df/dt, order by order (Leibniz). `speed` is
/// γ' with its derivatives by t.
template <class Number>
std::vector<Number> over_speed(const std::vector<Number>& slope, const std::vector<Number>& speed) {
  std::vector<Number> result(slope.size());
  for (std::size_t n = 0; n < slope.size(); ++n) {
    Number sum = slope[n];
    for (std::size_t i = 1; i <= n; ++i) {
      sum = sum - Number{binomial(n, i)} * speed[i] * result[n - i];
    }
    result[n] = sum / speed[0];
  }
  return result;
}

/// Derivatives of f by γ from those by t: d/dγ = (1/γ') d/dt, again and again.
template <class Number>
std::vector<Number> jets_by_angle(std::vector<Number> jets, const std::vector<Number>& speed) {
  const std::size_t count = jets.size();
  std::vector<Number> result;
  for (std::size_t k = 0; k < count; ++k) {
    result.push_back(jets[0]);
    jets = over_speed(std::vector<Number>(jets.begin() + 1, jets.end()), speed);
  }
  return result;
}

}  // namespace kinestat
