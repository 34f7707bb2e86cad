// Parts of a closure that become singular by themselves.
#pragma once

#include <vector>

namespace kinestat {

/// Rows and unknowns of a part, ascending. What another part has found may enter its equations;
/// whether it determines its own unknowns is a question of the part alone.
struct ClosureBlock {
  std::vector<int> rows;
  std::vector<int> columns;
};

/// `row_columns`: of each row the columns in which it may have entries. A square closure falls into
/// its irreducible diagonal blocks; one that is not, or that is singular by its pattern alone, into
/// connected parts.
std::vector<ClosureBlock> find_closure_blocks(const std::vector<std::vector<int>>& row_columns,
                                              int column_count);

}  // namespace kinestat
