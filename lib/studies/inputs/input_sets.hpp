// Which magnitudes may be given so that the equations determine all others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

/// A set of primary magnitudes that determines the rest: a cobasis of the column matroid of M_N or
/// A_N (Alves 2023, section 3.4, p. 72).
struct InputSet {
  std::vector<int> magnitudes;  ///< ascending
  /// In (0, 1]: the smallest singular value of the rows of the magnitudes in an orthonormal basis
  /// of the solutions. It is that of the secondary system too if its equations are orthonormal, so
  /// its inverse bounds how much larger the others can be than the primaries. 0 would be a dead
  /// point. Lengths count in the mechanism's size.
  double conditioning = 0.0;
};

/// Magnitudes that depend on each other and on no others: each group is chosen from by itself.
struct InputGroup {
  std::vector<int> magnitudes;  ///< ascending
  int needed = 0;               ///< how many of them determine the others
  std::uint64_t count = 0;      ///< of its sets
  bool is_complete = true;      ///< false: there are more sets than were counted
  std::vector<InputSet> best;   ///< best conditioned first; equal ones in order of magnitudes
};

/// A valid set takes one set of each group.
struct InputSets {
  int needed = 0;
  std::vector<int> always_zero;  ///< magnitudes that no solution has
  std::vector<InputGroup> groups;

  /// Product over the groups, at most kMostSets.
  std::uint64_t count() const;

  /// Whether count() is exact.
  bool is_complete() const;
};

/// The largest number that a double, and so the report, holds exactly: 2^53.
constexpr std::uint64_t kMostSets = std::uint64_t{1} << 53U;

/// What to choose from, and how much to say of it.
struct InputChoice {
  std::vector<int> among;     ///< only these; empty: all
  std::vector<int> required;  ///< each set has these
  std::size_t listed = 100;   ///< at most so many sets a group
};

/// `solutions` has one row a magnitude and a column for each independent solution. Counts up to ten
/// million sets, fewer where they are found slowly; the first hundred thousand of a group in the
/// order of their magnitudes are ranked, of large sets fewer. Several groups share these bounds, so
/// that many take little longer than one.
InputSets find_input_sets(const MatX& solutions, const InputChoice& choice = {});

/// The smallest singular value described at InputSet, of any choice of as many magnitudes as there
/// are solutions; 0 if they are dependent.
double conditioning_of(const MatX& solutions, std::span<const int> magnitudes);

}  // namespace kinestat
