// The methods that are held against each other.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "math/elimination/exact_elimination.hpp"
#include "math/numbers/double_double.hpp"
#include "studies/benchmark/solve_problem.hpp"

namespace kinestat {

/// The first four take the dense equations of the textbook, the others the sparse ones of the
/// nodes; double_lu is the unit of time.
enum class SolveMethod {
  float_lu,
  double_lu,
  long_double_lu,
  singular_values,
  fast,     ///< sparse elimination in doubles
  bounded,  ///< with a bound on its error
  high,     ///< refined with a residual of twice the digits, bounded
  exact     ///< fractions
};

inline constexpr std::array<SolveMethod, 8> kSolveMethods = {SolveMethod::float_lu,
                                                             SolveMethod::double_lu,
                                                             SolveMethod::long_double_lu,
                                                             SolveMethod::singular_values,
                                                             SolveMethod::fast,
                                                             SolveMethod::bounded,
                                                             SolveMethod::high,
                                                             SolveMethod::exact};

/// "float_lu" and so on: the key in reports.
std::string_view key_of(SolveMethod method);

/// A few words: "dense LU, float".
std::string_view words_of(SolveMethod method);

/// What a method says of the secondary magnitudes, in the units of the node system.
struct MethodAnswer {
  std::vector<DoubleDouble> x;  ///< empty: it refuses
  std::optional<VecX> bound;    ///< of the error of each, where the method gives one
};

/// A problem made ready for its methods: what is done once does not count in their time.
class PreparedProblem {
 public:
  explicit PreparedProblem(SolveProblem problem);

  const SolveProblem& problem() const { return problem_; }

  /// From the equations to the answer. That of `exact` is rounded to two doubles.
  MethodAnswer solve(SolveMethod method) const;

  /// The same with the answer as the method itself has it, for timing.
  void run(SolveMethod method) const;

 private:
  MethodAnswer solve_dense(SolveMethod method) const;
  MethodAnswer solve_sparse(SolveMethod method) const;
  MethodAnswer pick(const std::vector<DoubleDouble>& x, const std::optional<VecX>& bound) const;

  SolveProblem problem_;
  ExactMatrix exact_matrix_;
  std::vector<Rational> exact_known_;
  std::vector<Rational> exact_right_;
};

}  // namespace kinestat
