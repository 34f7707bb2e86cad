// Arithmetic of values with their derivatives by one parameter; for any type of number.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "studies/synthesis/dyads/precise_point.hpp"

namespace kinestat {

/// Binomial coefficient n over k, for the small orders of jets.
constexpr double binomial(std::size_t n, std::size_t k) {
  double result = 1.0;
  for (std::size_t i = 1; i <= k; ++i) {
    result = result * static_cast<double>(n - k + i) / static_cast<double>(i);
  }
  return result;
}

/// Derivative k of a product (Leibniz).
template <class Scalar>
Scalar product_jet(const std::vector<Scalar>& a, const std::vector<Scalar>& b, std::size_t k) {
  Scalar sum(0);
  for (std::size_t i = 0; i <= k; ++i) {
    sum += Scalar(binomial(k, i)) * a[i] * b[k - i];
  }
  return sum;
}

/// The turn from one angle to another, at most half a turn; zero where rounding alone tells the
/// angles apart.
template <class Scalar>
Scalar turn_between(const Scalar& from, const Scalar& to) {
  using std::abs;
  using std::acos;
  using std::round;
  const Scalar full = 2 * acos(Scalar(-1));
  const Scalar turn = (to - from) - full * round((to - from) / full);
  const Scalar rounding = sum_rounding<Scalar>() * (abs(from) + abs(to));
  return abs(turn) <= rounding ? Scalar(0) : turn;
}

/// Derivatives of the cosine and the sine of an angle that is given with its own.
template <class Scalar>
std::pair<std::vector<Scalar>, std::vector<Scalar>> turn_jets(const std::vector<Scalar>& angle) {
  using std::cos;
  using std::sin;
  std::vector<Scalar> cosine{cos(angle[0])};
  std::vector<Scalar> sine{sin(angle[0])};
  for (std::size_t k = 1; k < angle.size(); ++k) {
    // c' = -s γ', s' = c γ'; the derivative k - 1 of these products.
    Scalar c(0);
    Scalar s(0);
    for (std::size_t i = 0; i < k; ++i) {
      const Scalar factor = Scalar(binomial(k - 1, i)) * angle[k - i];
      c -= factor * sine[i];
      s += factor * cosine[i];
    }
    cosine.push_back(c);
    sine.push_back(s);
  }
  return {std::move(cosine), std::move(sine)};
}

}  // namespace kinestat
