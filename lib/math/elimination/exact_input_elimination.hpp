// The questions of an elimination, asked of the numbers as typed.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/types.hpp"
#include "math/elimination/exact_rank.hpp"
#include "math/numbers/exact_input.hpp"

namespace kinestat {

struct ExactInputEntry {
  int row = 0;
  int column = 0;
  ExactInput value;
};

/// Entries in any order; entries at the same place add up.
struct ExactInputMatrix {
  int rows = 0;
  int columns = 0;
  std::vector<ExactInputEntry> entries;
};

/// Whether every number has its digits; without them there is nothing to ask.
bool has_digits(const ExactInputMatrix& matrix);

/// Whether every number is a fraction.
bool is_rational(const ExactInputMatrix& matrix);

/// Why a rank as typed is what it is said to be.
enum class ExactInputProof {
  structural,   ///< no zero modulo a prime, and the pattern of entries allows no more
  elimination,  ///< eliminated without rounding
  modular,      ///< modulo primes drawn at random
  digits        ///< numbers that have no exact value: what is zero in 60 digits counted as zero
};

struct ExactInputRank {
  int rank = 0;
  ExactInputProof proof = ExactInputProof::structural;
  double error_probability = 0.0;  ///< of a modular rank: that it is larger
};

/// The rank of numbers as typed. `upper_bound` must be proved by their pattern. Empty without
/// digits.
std::optional<ExactInputRank> find_exact_input_rank(const ExactInputMatrix& matrix,
                                                    int upper_bound);

/// Solution of A x = b with some of x known.
struct ExactInputSolution {
  VecX x;      ///< the nearest doubles; free columns are 0
  VecX bound;  ///< how far each may be from the solution: the rounding to a double, and
               ///< twice the next correction where 100 digits were rounded
  bool consistent = false;  ///< the surplus equations hold, in all but 40 of the hundred digits
  bool is_exact = false;    ///< fractions all the way; only x is rounded
};

/// Gaussian elimination in fractions where all numbers are, otherwise in a hundred digits, where
/// what is below 10^-60 of its row and column counts as zero. The matrix must have digits.
class ExactInputElimination {
 public:
  /// `last` holds the columns whose x is to be known; it may be empty.
  ExactInputElimination(ExactInputMatrix matrix, std::span<const int> last);
  ~ExactInputElimination();
  ExactInputElimination(ExactInputElimination&& other) noexcept;
  ExactInputElimination& operator=(ExactInputElimination&& other) noexcept;
  ExactInputElimination(const ExactInputElimination&) = delete;
  ExactInputElimination& operator=(const ExactInputElimination&) = delete;

  int rank() const;

  /// Columns outside `last` that no equation determines, ascending.
  const std::vector<int>& free_columns() const;

  /// How many independent relations the equations ask of the columns of `last`.
  int relation_count() const;

  /// In fractions where `known` and `rhs` (one an equation, or empty: zero) are fractions too.
  /// Empty where a number has no digits.
  std::optional<ExactInputSolution> solve(std::span<const ExactInput> known,
                                          std::span<const ExactInput> rhs) const;

 private:
  struct Factors;

  std::unique_ptr<Factors> factors_;
};

}  // namespace kinestat
