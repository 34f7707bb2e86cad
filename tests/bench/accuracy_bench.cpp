// Times the precisions of accuracy on the statics of one case, in units of a dense solve by LAPACK,
// and measures what each leaves of the error.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench_program.hpp"
#include "dense_statics.hpp"
#include "interleave.hpp"
#include "math/elimination/exact_elimination.hpp"
#include "math/elimination/exact_rank.hpp"
#include "math/elimination/refined_solve.hpp"
#include "network/node_system.hpp"
#include "subject.hpp"

namespace kinestat::bench {

namespace {

constexpr double kHighTarget = 1.5;
constexpr double kExactTarget = 15.0;

/// The equilibrium of a case, with the columns and values of its primary actions, as doubles and as
/// these very doubles exactly.
struct Statics {
  SparseMatrix matrix;
  ExactMatrix exact;
  std::vector<int> columns;
  std::vector<double> known;
  std::vector<Rational> exact_known;
};

Statics statics_of(const Subject& subject) {
  const Mechanism& mechanism = subject.loaded.mechanism;
  Statics statics;
  statics.matrix = action_system(mechanism.topology, mechanism.geometry, subject.action);
  statics.exact = exact_matrix(statics.matrix);
  for (const Primary& primary : subject.which.actions) {
    statics.columns.push_back(primary.index);
    statics.known.push_back(primary.value);
    statics.exact_known.emplace_back(primary.value);
  }
  return statics;
}

// From the matrix to the solution; `steps` of refinement, and the bound if asked for.
void solve_refined(const Statics& statics, int steps, bool has_bound) {
  const Elimination factors(statics.matrix, statics.columns);
  RefinedSolve solve(factors, statics.known, {});
  for (int i = 0; i < steps; ++i) {
    solve.refine();
  }
  keep(solve.x());
  if (has_bound) {
    keep(solve.error_bound());
  }
}

std::vector<Job> jobs_of(const Statics& statics) {
  return {{"double",
           [&] { keep(Elimination(statics.matrix, statics.columns).solve(statics.known, {})); },
           {}},
          {"double, bounded", [&] { solve_refined(statics, 0, true); }, {}},
          {"high, without its bound", [&] { solve_refined(statics, 1, false); }, {}},
          {"high, bounded", [&] { solve_refined(statics, 1, true); }, kHighTarget},
          {"exact",
           [&] {
             keep(ExactElimination(statics.exact, statics.columns).solve(statics.exact_known, {}));
           },
           kExactTarget},
          {"exact rank", [&] { keep(find_exact_rank(statics.exact, statics.exact.rows)); }, {}}};
}

// The largest error and bound after so many steps, in units of the largest unknown.
std::string errors_after(const Statics& statics, int steps) {
  const Elimination factors(statics.matrix, statics.columns);
  const ExactSolution exact =
      ExactElimination(statics.exact, statics.columns).solve(statics.exact_known, {});
  RefinedSolve solve(factors, statics.known, {});
  for (int i = 0; i < steps; ++i) {
    solve.refine();
  }
  const std::optional<VecX> bound = solve.error_bound();
  if (!bound || !exact.consistent || !factors.free_columns().empty()) {
    throw std::runtime_error("the statics have no bounded solution");
  }
  const std::vector<DoubleDouble> x = solve.x();
  double largest = 0.0;
  double error = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Rational difference = exact.x[i] - Rational(x[i].high) - Rational(x[i].low);
    error = std::max(error, std::abs(to_double(difference)));
    largest = std::max(largest, std::abs(x[i].high));
  }
  return fmt::format("after {} steps of refinement: error {:.1e}, bound {:.1e} of the largest\n",
                     steps,
                     error / largest,
                     bound->maxCoeff() / largest);
}

std::string run(const Options& options) {
  const Subject subject = read_subject(KINESTAT_MECHANISM, "M1");
  DenseStatics dense(subject.loaded.mechanism, subject.action, subject.which);
  if (!dense.is_square() || !dense.agrees(subject.loaded.mechanism.topology, action_of(subject))) {
    throw std::runtime_error("solve_action and dgesv disagree");
  }
  const Statics statics = statics_of(subject);
  const Interleaved result = measure([&] { dense.solve(); }, jobs_of(statics), options.rounds);
  std::string text = write_ratios(result.ratios, "D", options.form);
  if (options.form == TableForm::text) {
    text += fmt::format(
        "D = dgesv of {0} x {0}, here {1:.1f} µs\n", dense.size(), 1e6 * result.unit_seconds);
    text += errors_after(statics, 0) + errors_after(statics, 1) + errors_after(statics, 2);
  }
  return text;
}

}  // namespace

}  // namespace kinestat::bench

int main(int argc, char** argv) {
  return kinestat::bench::run_program("accuracy_bench", argc, argv, kinestat::bench::run);
}
