#include "studies/benchmark/solve_method.hpp"

#include <cmath>
#include <utility>

#include "math/dense/dense_methods.hpp"
#include "math/elimination/elimination.hpp"
#include "math/elimination/refined_solve.hpp"

namespace kinestat {

namespace {

struct MethodWords {
  std::string_view key;
  std::string_view words;
};

// In the order of the enumerators.
constexpr std::array<MethodWords, 8> kWords = {{
    {.key = "float_lu", .words = "dense LU, float"},
    {.key = "double_lu", .words = "dense LU, double"},
    {.key = "long_double_lu", .words = "dense LU, long double"},
    {.key = "singular_values", .words = "dense SVD, double"},
    {.key = "fast", .words = "fast: sparse, double"},
    {.key = "bounded", .words = "with its bound"},
    {.key = "high", .words = "high: refined, bounded"},
    {.key = "exact", .words = "exact: fractions"},
}};

const MethodWords& row_of(SolveMethod method) {
  return kWords[static_cast<std::size_t>(method)];
}

std::optional<DenseMethod> dense_method(SolveMethod method) {
  switch (method) {
    case SolveMethod::float_lu:
      return DenseMethod::float_lu;
    case SolveMethod::double_lu:
      return DenseMethod::double_lu;
    case SolveMethod::long_double_lu:
      return DenseMethod::long_double_lu;
    case SolveMethod::singular_values:
      return DenseMethod::singular_values;
    case SolveMethod::fast:
    case SolveMethod::bounded:
    case SolveMethod::high:
    case SolveMethod::exact:
      break;
  }
  return std::nullopt;
}

DoubleDouble two_doubles_of(const Rational& value) {
  const double high = to_double(value);
  return {.high = high, .low = std::isfinite(high) ? to_double(value - Rational(high)) : 0.0};
}

}  // namespace

std::string_view key_of(SolveMethod method) {
  return row_of(method).key;
}

std::string_view words_of(SolveMethod method) {
  return row_of(method).words;
}

PreparedProblem::PreparedProblem(SolveProblem problem)
    : problem_(std::move(problem)),
      exact_matrix_(exact_matrix(problem_.matrix)),
      exact_known_(problem_.known.begin(), problem_.known.end()),
      exact_right_(problem_.right.begin(), problem_.right.end()) {}

MethodAnswer PreparedProblem::solve(SolveMethod method) const {
  if (dense_method(method)) {
    return solve_dense(method);
  }
  if (method != SolveMethod::exact) {
    return solve_sparse(method);
  }
  MethodAnswer answer;
  for (const Rational& value : problem_.exact) {
    answer.x.push_back(two_doubles_of(value));
  }
  return answer;
}

void PreparedProblem::run(SolveMethod method) const {
  if (method == SolveMethod::exact) {
    ExactElimination(exact_matrix_, problem_.last).solve(exact_known_, exact_right_);
  } else {
    solve(method);
  }
}

MethodAnswer PreparedProblem::solve_dense(SolveMethod method) const {
  MethodAnswer answer;
  answer.x = solve_by(*dense_method(method), problem_.dense, problem_.dense_right);
  // Units are powers of two: nothing is rounded.
  for (std::size_t i = 0; i < answer.x.size(); ++i) {
    const double unit = problem_.units[static_cast<Eigen::Index>(i)];
    answer.x[i] = {.high = answer.x[i].high / unit, .low = answer.x[i].low / unit};
  }
  return answer;
}

MethodAnswer PreparedProblem::solve_sparse(SolveMethod method) const {
  const Elimination factors(problem_.matrix, problem_.last);
  if (!factors.free_columns().empty()) {
    return {};
  }
  if (method == SolveMethod::fast) {
    const EliminationSolution solved = factors.solve(problem_.known, problem_.right);
    MethodAnswer answer;
    for (const int c : problem_.secondary) {
      answer.x.push_back({.high = solved.x[c], .low = 0.0});
    }
    return answer;
  }
  RefinedSolve refined(factors, problem_.known, problem_.right);
  if (method == SolveMethod::high) {
    refined.refine();
  }
  return pick(refined.x(), refined.error_bound());
}

MethodAnswer PreparedProblem::pick(const std::vector<DoubleDouble>& x,
                                   const std::optional<VecX>& bound) const {
  MethodAnswer answer;
  for (const int c : problem_.secondary) {
    answer.x.push_back(x[static_cast<std::size_t>(c)]);
  }
  if (bound) {
    answer.bound = (*bound)(problem_.secondary);
  }
  return answer;
}

}  // namespace kinestat
