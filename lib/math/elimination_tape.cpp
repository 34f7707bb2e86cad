#include "math/elimination_tape.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/internal/tape_recorder.hpp"

namespace kinestat {

namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

double without_rounding(double a, double b) {
  const double difference = a - b;
  return std::abs(difference) <= kCancellation * (std::abs(a) + std::abs(b)) ? 0.0 : difference;
}

std::optional<EliminationTape> EliminationTape::record(const SparseMatrix& matrix,
                                                       const std::vector<bool>& varies,
                                                       std::span<const int> last,
                                                       std::span<const int> wanted) {
  KINESTAT_EXPECTS(varies.size() == matrix.entries.size());
  TapeRecorder recorder(matrix, varies, last);
  return recorder.run(wanted) ? std::optional(recorder.take()) : std::nullopt;
}

EliminationTape::Workspace EliminationTape::make_workspace() const {
  return {.cells = cells_, .unknowns = std::vector<double>(scaling_.columns.size(), 0.0)};
}

// A factor beyond this means that the pivot was chosen for another matrix.
bool EliminationTape::play(const Subtraction& subtraction, std::vector<double>& cells) const {
  constexpr double kLargestFactor = 100.0;
  const double factor = cells[index(subtraction.entry)] / cells[index(subtraction.pivot)];
  for (int i = subtraction.first_step; i < subtraction.first_fill; ++i) {
    const Step& step = steps_[index(i)];
    double& target = cells[index(step.target)];
    target = without_rounding(target, factor * cells[index(step.source)]);
  }
  for (int i = subtraction.first_fill; i < subtraction.end; ++i) {
    const Step& step = steps_[index(i)];
    cells[index(step.target)] = -(factor * cells[index(step.source)]);
  }
  return std::abs(factor) <= kLargestFactor;
}

bool EliminationTape::eliminate(Workspace& workspace) const {
  bool is_stable = true;
  for (const Subtraction& subtraction : subtractions_) {
    is_stable = play(subtraction, workspace.cells) && is_stable;
  }
  return is_stable && is_good(workspace.cells);
}

bool EliminationTape::is_good(const std::vector<double>& cells) const {
  return std::ranges::all_of(
             pivots_, [&](int cell) { return std::abs(cells[index(cell)]) >= kSafePivot; }) &&
         std::ranges::all_of(surplus_,
                             [&](int cell) { return std::abs(cells[index(cell)]) <= kRankZero; });
}

void EliminationTape::solve(Workspace& workspace, std::span<const double> known) const {
  std::vector<double>& x = workspace.unknowns;
  for (std::size_t i = 0; i < last_.size(); ++i) {
    x[index(last_[i])] = known[i] / scaling_.columns[index(last_[i])];
  }
  for (const Substitution& one : substitutions_) {
    double sum = 0.0;
    double size = 0.0;
    for (int i = one.first_term; i < one.end; ++i) {
      const Term& term = terms_[index(i)];
      const double product = workspace.cells[index(term.cell)] * x[index(term.column)];
      sum -= product;
      size += std::abs(product);
    }
    x[index(one.column)] =
        std::abs(sum) <= kCancellation * size ? 0.0 : sum / workspace.cells[index(one.pivot)];
  }
}

}  // namespace kinestat
