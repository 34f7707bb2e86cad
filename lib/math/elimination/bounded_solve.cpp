#include "math/elimination/bounded_solve.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "math/elimination/refined_solve.hpp"

namespace kinestat {

namespace {

// A step gains sixteen digits but for the condition: more do not help where three have not.
constexpr int kMostRefinements = 3;

bool at_index(const std::vector<bool>& list, Eigen::Index i) {
  return list[static_cast<std::size_t>(i)];
}

// What its bound does not tell from zero is zero.
void make_zeros(const std::optional<VecX>& bound, VecX& x) {
  if (bound) {
    x = (x.array().abs() <= bound->array() && bound->array().isFinite()).select(0.0, x);
  }
}

// The high parts; what they leave out adds to the bound.
VecX rounded(const std::vector<DoubleDouble>& x, std::optional<VecX>& bound) {
  VecX high(static_cast<Eigen::Index>(x.size()));
  for (Eigen::Index i = 0; i < high.size(); ++i) {
    const DoubleDouble& value = x[static_cast<std::size_t>(i)];
    high[i] = value.high;
    if (bound) {
      (*bound)[i] += std::abs(value.low);
    }
  }
  return high;
}

}  // namespace

double largest_size(std::span<const double> numbers) {
  double largest = 0.0;
  for (const double number : numbers) {
    largest = std::max(largest, std::abs(number));
  }
  return largest;
}

double worst_relative_error(const VecX& values,
                            const VecX& bounds,
                            const std::vector<bool>& counts,
                            double largest_right) {
  double largest = largest_right;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    largest = at_index(counts, i) ? std::max(largest, std::abs(values[i])) : largest;
  }
  double worst = 0.0;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double size = std::abs(values[i]);
    const bool is_zero = size <= bounds[i] && bounds[i] <= kNoDigitsAsked * largest;
    if (at_index(counts, i) && bounds[i] > 0.0 && !is_zero) {
      worst = std::max(worst, size > bounds[i] ? bounds[i] / size : 1.0);
    }
  }
  return worst;
}

BoundedSolution solve_to_digits(const Elimination& elimination,
                                std::span<const double> known,
                                std::span<const double> rhs,
                                const AccuracyRequest& request,
                                const std::vector<bool>& counts) {
  BoundedSolution result;
  result.solution = elimination.solve(known, rhs);
  if (request.accuracy == Accuracy::fast || !result.solution.x.allFinite()) {
    return result;
  }
  const bool only_if_needed = request.accuracy == Accuracy::automatic;
  const double asked = only_if_needed ? std::pow(10.0, -request.digits) : kEpsilon;
  RefinedSolve refined(elimination, known, rhs);
  const auto worst_error = [&, largest_right = largest_size(rhs)] {
    return worst_relative_error(result.solution.x, *result.bound, counts, largest_right);
  };
  if (only_if_needed) {
    result.bound = refined.error_bound();
    if (result.bound && worst_error() <= asked) {
      make_zeros(result.bound, result.solution.x);
      return result;
    }
  }
  for (int step = 0; step < kMostRefinements; ++step) {
    refined.refine();
    result.bound = refined.error_bound();
    result.solution.x = rounded(refined.x(), result.bound);
    if (!result.bound || worst_error() <= asked) {
      break;
    }
  }
  make_zeros(result.bound, result.solution.x);
  result.precision = Precision::refined;
  result.solution.residual = elimination.residual(result.solution.x, rhs);
  return result;
}

}  // namespace kinestat
