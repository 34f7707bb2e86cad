#include "studies/motion/internal/closure_blocks.hpp"

#include <algorithm>
#include <optional>

#include "core/index.hpp"
#include "graph/components.hpp"
#include "graph/matching.hpp"

namespace kinestat {

namespace {

// Each row with the unknown that it is matched to: row r needs row s where it has s's unknown.
std::vector<ClosureBlock> diagonal_blocks(const std::vector<std::vector<int>>& row_columns,
                                          const std::vector<std::optional<int>>& matched) {
  const int count = static_cast<int>(row_columns.size());
  std::vector<int> row_of(at(count));
  for (int r = 0; r < count; ++r) {
    row_of[at(*matched[at(r)])] = r;
  }
  Digraph needs{.vertex_count = count, .edges = {}};
  for (int r = 0; r < count; ++r) {
    for (const int column : row_columns[at(r)]) {
      if (row_of[at(column)] != r) {
        needs.edges.push_back({.tail = r, .head = row_of[at(column)]});
      }
    }
  }
  std::vector<std::vector<int>> parts = find_strong_components(needs);
  std::vector<bool> is_in_cycle(at(count), false);
  for (const std::vector<int>& part : parts) {
    for (const int r : part) {
      is_in_cycle[at(r)] = true;
    }
  }
  for (int r = 0; r < count; ++r) {
    if (!is_in_cycle[at(r)]) {
      parts.push_back({r});
    }
  }
  std::vector<ClosureBlock> blocks;
  for (std::vector<int>& part : parts) {
    ClosureBlock block{.rows = std::move(part), .columns = {}};
    for (const int r : block.rows) {
      block.columns.push_back(*matched[at(r)]);
    }
    std::ranges::sort(block.columns);
    blocks.push_back(std::move(block));
  }
  return blocks;
}

std::vector<ClosureBlock> connected_blocks(const std::vector<std::vector<int>>& row_columns,
                                           int column_count) {
  Digraph graph{.vertex_count = column_count + static_cast<int>(row_columns.size()), .edges = {}};
  for (std::size_t r = 0; r < row_columns.size(); ++r) {
    for (const int column : row_columns[r]) {
      graph.edges.push_back({.tail = column_count + static_cast<int>(r), .head = column});
    }
  }
  std::vector<ClosureBlock> blocks;
  for (const std::vector<int>& part : find_components(graph)) {
    ClosureBlock block;
    for (const int vertex : part) {
      (vertex < column_count ? block.columns : block.rows)
          .push_back(vertex < column_count ? vertex : vertex - column_count);
    }
    if (!block.rows.empty() && !block.columns.empty()) {
      blocks.push_back(std::move(block));
    }
  }
  return blocks;
}

}  // namespace

std::vector<ClosureBlock> find_closure_blocks(const std::vector<std::vector<int>>& row_columns,
                                              int column_count) {
  if (static_cast<int>(row_columns.size()) == column_count) {
    const auto matched = find_matching(row_columns, column_count);
    if (std::ranges::all_of(matched, [](const auto& one) { return one.has_value(); })) {
      return diagonal_blocks(row_columns, matched);
    }
  }
  return connected_blocks(row_columns, column_count);
}

}  // namespace kinestat
