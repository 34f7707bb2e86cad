#include "math/dense/polynomial.hpp"

#include <cstddef>

namespace kinestat {

namespace {

std::vector<double> derivative_of(const std::vector<double>& coefficients) {
  std::vector<double> result;
  for (std::size_t i = 1; i < coefficients.size(); ++i) {
    result.push_back(static_cast<double>(i) * coefficients[i]);
  }
  return result;
}

// The values at both ends have different signs.
double bisect(const std::vector<double>& coefficients, double low, double high) {
  const bool rises = polynomial_value(coefficients, high) > 0.0;
  while (true) {
    const double middle = low + 0.5 * (high - low);
    if (!(middle > low && middle < high)) {
      return middle;
    }
    ((polynomial_value(coefficients, middle) > 0.0) == rises ? high : low) = middle;
  }
}

}  // namespace

double polynomial_value(const std::vector<double>& coefficients, double x) {
  double value = 0.0;
  for (std::size_t i = coefficients.size(); i > 0; --i) {
    value = value * x + coefficients[i - 1];
  }
  return value;
}

std::vector<double> find_sign_changes(const std::vector<double>& coefficients,
                                      double low,
                                      double high) {
  if (coefficients.size() < 2) {
    return {};
  }
  std::vector<double> marks = find_sign_changes(derivative_of(coefficients), low, high);
  marks.push_back(high);
  std::vector<double> roots;
  double from = low;
  for (const double to : marks) {
    const bool before = polynomial_value(coefficients, from) > 0.0;
    const bool after = polynomial_value(coefficients, to) > 0.0;
    if (before != after) {
      roots.push_back(bisect(coefficients, from, to));
    }
    from = to;
  }
  return roots;
}

}  // namespace kinestat
