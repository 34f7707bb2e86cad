#include "math/elimination/exact_input_elimination.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/elimination/equilibrate.hpp"
#include "math/elimination/internal/decimal_solve.hpp"
#include "math/elimination/internal/field_eliminator.hpp"
#include "math/numbers/internal/unit_roundoff.hpp"

namespace kinestat {

namespace {

// The common field of a matrix of exact numbers; beyond this its primes are hard to find.
constexpr int kMostCommonRoots = 1 << 16;

// The rows and columns that doubles would have; where all doubles of a line are zero or beyond
// their range, 1.
Scaling scaling_of(const ExactInputMatrix& matrix) {
  SparseMatrix doubles{.rows = matrix.rows, .columns = matrix.columns, .entries = {}};
  for (const ExactInputEntry& entry : matrix.entries) {
    if (entry.value.precise) {
      doubles.add(entry.row, entry.column, static_cast<double>(*entry.value.precise));
    }
  }
  return find_scaling(doubles);
}

std::vector<DecimalEntry> scaled_entries(const ExactInputMatrix& matrix, const Scaling& scaling) {
  std::vector<DecimalEntry> entries;
  entries.reserve(matrix.entries.size());
  for (const ExactInputEntry& entry : matrix.entries) {
    entries.push_back({.row = entry.row,
                       .column = entry.column,
                       .value = *entry.value.precise * BigFloat(at(scaling.rows, entry.row)) *
                                BigFloat(at(scaling.columns, entry.column))});
  }
  return entries;
}

DecimalFactors eliminate_decimals(const ExactInputMatrix& matrix, std::span<const int> last) {
  DecimalFactors result{.scaling = scaling_of(matrix), .entries = {}, .decimals = {.field = {}}};
  result.entries = scaled_entries(matrix, result.scaling);
  result.decimals.load(matrix.rows, result.entries, [](const BigFloat& value) { return value; });
  FieldEliminator(result.decimals, matrix.columns).run(last);
  return result;
}

ExactMatrix rational_matrix(const ExactInputMatrix& matrix) {
  ExactMatrix result{.rows = matrix.rows, .columns = matrix.columns, .entries = {}};
  for (const ExactInputEntry& entry : matrix.entries) {
    result.entries.push_back(
        {.row = entry.row, .column = entry.column, .value = *rational_of(entry.value)});
  }
  return result;
}

// Empty if an entry is no such sum, holds pi, or if the fields have too large a common one.
std::optional<RootMatrix> root_matrix(const ExactInputMatrix& matrix) {
  int count = 4;
  for (const ExactInputEntry& entry : matrix.entries) {
    if (!entry.value.exact || entry.value.pi_power != 0) {
      return std::nullopt;
    }
    count = std::lcm(count, entry.value.exact->root_count());
    if (count > kMostCommonRoots) {
      return std::nullopt;
    }
  }
  RootMatrix result{
      .rows = matrix.rows, .columns = matrix.columns, .root_count = count, .entries = {}};
  for (const ExactInputEntry& entry : matrix.entries) {
    result.entries.push_back(
        {.row = entry.row, .column = entry.column, .value = entry.value.exact->in_field(count)});
  }
  return result;
}

ExactInputRank exact_input(const ExactRank& found) {
  ExactInputRank result{.rank = found.rank, .error_probability = found.error_probability};
  switch (found.proof) {
    case RankProof::structural:
      result.proof = ExactInputProof::structural;
      break;
    case RankProof::elimination:
    case RankProof::null_vectors:
      result.proof = ExactInputProof::elimination;
      break;
    case RankProof::modular:
      result.proof = ExactInputProof::modular;
      break;
  }
  return result;
}

std::optional<std::vector<Rational>> rational_list(std::span<const ExactInput> numbers) {
  std::vector<Rational> result;
  for (const ExactInput& number : numbers) {
    const std::optional<Rational> value = rational_of(number);
    if (!value) {
      return std::nullopt;
    }
    result.push_back(*value);
  }
  return result;
}

bool have_digits(std::span<const ExactInput> numbers) {
  return std::ranges::all_of(numbers,
                             [](const ExactInput& one) { return one.precise.has_value(); });
}

}  // namespace

bool has_digits(const ExactInputMatrix& matrix) {
  return std::ranges::all_of(
      matrix.entries, [](const ExactInputEntry& one) { return one.value.precise.has_value(); });
}

bool is_rational(const ExactInputMatrix& matrix) {
  return std::ranges::all_of(matrix.entries, [](const ExactInputEntry& one) {
    return rational_of(one.value).has_value();
  });
}

std::optional<ExactInputRank> find_exact_input_rank(const ExactInputMatrix& matrix,
                                                    int upper_bound) {
  if (!has_digits(matrix)) {
    return std::nullopt;
  }
  if (is_rational(matrix)) {
    return exact_input(find_exact_rank(rational_matrix(matrix), upper_bound));
  }
  if (const std::optional<RootMatrix> roots = root_matrix(matrix)) {
    return exact_input(find_exact_rank(*roots, upper_bound));
  }
  return ExactInputRank{.rank = eliminate_decimals(matrix, {}).decimals.rank(),
                        .proof = ExactInputProof::digits};
}

struct ExactInputElimination::Factors {
  ExactInputMatrix matrix;
  std::vector<int> last;
  std::optional<ExactElimination> fractions;
  std::optional<DecimalFactors> decimals;  ///< where there are no fractions

  ExactInputSolution solve_in_fractions(std::span<const Rational> known,
                                        std::span<const Rational> rhs) const;
  std::optional<ExactInputSolution> solve_in_decimals(std::span<const ExactInput> known,
                                                      std::span<const ExactInput> rhs) const;
};

ExactInputElimination::ExactInputElimination(ExactInputMatrix matrix, std::span<const int> last)
    : factors_(std::make_unique<Factors>()) {
  KINESTAT_EXPECTS(has_digits(matrix));
  factors_->matrix = std::move(matrix);
  factors_->last.assign(last.begin(), last.end());
  if (is_rational(factors_->matrix)) {
    factors_->fractions.emplace(rational_matrix(factors_->matrix), last);
  } else {
    factors_->decimals = eliminate_decimals(factors_->matrix, last);
  }
}

ExactInputElimination::~ExactInputElimination() = default;
ExactInputElimination::ExactInputElimination(ExactInputElimination&& other) noexcept = default;
ExactInputElimination& ExactInputElimination::operator=(ExactInputElimination&& other) noexcept =
    default;

int ExactInputElimination::rank() const {
  return factors_->fractions ? factors_->fractions->rank() : factors_->decimals->decimals.rank();
}

const std::vector<int>& ExactInputElimination::free_columns() const {
  return factors_->fractions ? factors_->fractions->free_columns()
                             : factors_->decimals->decimals.free_columns;
}

int ExactInputElimination::relation_count() const {
  return factors_->fractions ? factors_->fractions->relation_count()
                             : static_cast<int>(factors_->decimals->decimals.last_pivots.size());
}

std::optional<ExactInputSolution> ExactInputElimination::solve(
    std::span<const ExactInput> known, std::span<const ExactInput> rhs) const {
  KINESTAT_EXPECTS(known.size() == factors_->last.size());
  KINESTAT_EXPECTS(rhs.empty() || rhs.size() == static_cast<std::size_t>(factors_->matrix.rows));
  if (factors_->fractions) {
    const auto values = rational_list(known);
    const auto right = rational_list(rhs);
    if (values && right) {
      return factors_->solve_in_fractions(*values, *right);
    }
  }
  return have_digits(known) && have_digits(rhs) ? factors_->solve_in_decimals(known, rhs)
                                                : std::nullopt;
}

ExactInputSolution ExactInputElimination::Factors::solve_in_fractions(
    std::span<const Rational> known, std::span<const Rational> rhs) const {
  const ExactSolution found = fractions->solve(known, rhs);
  ExactInputSolution result{
      .x = VecX(matrix.columns), .bound = {}, .consistent = found.consistent, .is_exact = true};
  for (int c = 0; c < matrix.columns; ++c) {
    result.x[c] = to_double(at(found.x, c));
  }
  result.bound = kUnitRoundoff * result.x.cwiseAbs();
  return result;
}

// Where the matrix has fractions, its digits must say the same of it.
std::optional<ExactInputSolution> ExactInputElimination::Factors::solve_in_decimals(
    std::span<const ExactInput> known, std::span<const ExactInput> rhs) const {
  const std::optional<DecimalFactors> own =
      decimals ? std::nullopt : std::optional(eliminate_decimals(matrix, last));
  const DecimalFactors& factors = decimals ? *decimals : *own;
  if (fractions && (factors.decimals.rank() != fractions->rank() ||
                    factors.decimals.free_columns != fractions->free_columns())) {
    return std::nullopt;
  }
  std::vector<BigFloat> x(static_cast<std::size_t>(matrix.columns));
  for (std::size_t i = 0; i < known.size(); ++i) {
    at(x, last[i]) = *known[i].precise / BigFloat(at(factors.scaling.columns, last[i]));
  }
  std::vector<BigFloat> b(static_cast<std::size_t>(matrix.rows));
  for (std::size_t r = 0; r < rhs.size(); ++r) {
    b[r] = *rhs[r].precise * BigFloat(factors.scaling.rows[r]);
  }
  return solve_decimals(factors, std::move(x), b);
}

}  // namespace kinestat
