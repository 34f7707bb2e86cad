// The rank that a pattern of entries allows.
#pragma once

#include <vector>

namespace kinestat {

/// The columns in which each row of a matrix has an entry, in any order.
using EntryPattern = std::vector<std::vector<int>>;

/// How many rows can be paired with columns in which they have an entry, each column with one row
/// at most. No matrix with this pattern has a larger rank, and nearly all have this one (Hopcroft
/// and Karp 1973: entries times the root of rows at most).
int structural_rank(const EntryPattern& pattern, int column_count);

}  // namespace kinestat
