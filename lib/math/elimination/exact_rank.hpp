// The rank of a matrix of exact numbers, and what is proved of it.
#pragma once

#include <string_view>
#include <vector>

#include "math/elimination/exact_elimination.hpp"
#include "math/numbers/root_sum.hpp"

namespace kinestat {

/// Why a rank is what it is said to be. That it is at least that is always proved.
enum class RankProof {
  structural,    ///< a minor is not zero modulo a prime, and the pattern of entries allows no more
  elimination,   ///< eliminated without rounding
  null_vectors,  ///< so many fractions x with A x = 0 are at hand that there is no room for more
  modular,       ///< the rank modulo primes drawn at random; that it is more is only unlikely
};

/// "structural bound", "exact elimination", "exact null vectors", "modulo two primes"
std::string_view text_of(RankProof proof);

struct ExactRank {
  int rank = 0;
  RankProof proof = RankProof::structural;
  double error_probability = 0.0;  ///< at most that of a larger rank, over the draw of the primes
};

struct RootEntry {
  int row = 0;
  int column = 0;
  RootSum value;
};

/// Entries in any order; entries at the same place add up. All have the same N.
struct RootMatrix {
  int rows = 0;
  int columns = 0;
  int root_count = 4;  ///< N
  std::vector<RootEntry> entries;
};

/// The rank of a matrix of fractions: modulo a prime of 61 bits first, and by elimination where
/// that does not reach `upper_bound`, which must be proved and may be the smaller side of the
/// matrix. Only where an elimination without rounding would take long, as in redundant grids of
/// thousands of bodies, a rank below `upper_bound` is `modular`.
ExactRank find_exact_rank(const ExactMatrix& matrix, int upper_bound);

/// The rank of a matrix of doubles, taken as the fractions that they are: likewise, but null
/// vectors of small fractions come before an elimination without rounding. Entries must be finite.
ExactRank find_exact_rank(const SparseMatrix& matrix, int upper_bound);

/// The rank of a matrix of sines and cosines of parts of a turn: likewise, and `modular` too where
/// φ(N) > kLargestDegree.
ExactRank find_exact_rank(const RootMatrix& matrix, int upper_bound);

/// A number of such a field has as many fractions; 24 covers trains with up to 12 planets.
inline constexpr int kLargestDegree = 24;

}  // namespace kinestat
