// A sparse matrix as the list of its entries.
#pragma once

#include <vector>

#include "core/types.hpp"

namespace kinestat {

struct SparseEntry {
  int row = 0;
  int column = 0;
  double value = 0.0;
};

/// Entries in any order; entries at the same place add up; exact zeros are not stored.
struct SparseMatrix {
  int rows = 0;
  int columns = 0;
  std::vector<SparseEntry> entries;

  void add(int row, int column, double value) {
    if (value != 0.0) {
      entries.push_back({.row = row, .column = column, .value = value});
    }
  }

  /// For display and tests.
  MatX dense() const {
    MatX result = MatX::Zero(rows, columns);
    for (const SparseEntry& entry : entries) {
      result(entry.row, entry.column) += entry.value;
    }
    return result;
  }
};

}  // namespace kinestat
