// Enumerates the choices of columns that are independent and as many as the rows.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

/// Of a matrix with orthonormal rows. Columns are taken one by one in ascending order; each is
/// eliminated from the rows that are left, so that a choice costs a fraction of a determinant.
class CobasisSearch {
 public:
  /// `rows` with orthonormal rows, `required` columns that each choice has, `allowed` ascending
  /// columns from which the others are taken.
  CobasisSearch(const MatX& rows, std::vector<int> required, std::vector<int> allowed);

  /// Calls `found` for each choice in lexicographic order of the columns that are not required,
  /// those first, until it returns false, or the search has looked at more entries than
  /// `most_work`: choices that cannot be completed are found late, and their number has no bound
  /// but the binomial. Whether all were found.
  bool run(std::uint64_t most_work, const std::function<bool(const std::vector<int>&)>& found);

  /// Entries that the last run looked at.
  std::uint64_t work() const { return work_; }

 private:
  // The rows that are left after some columns were chosen, one after the other.
  struct Level {
    std::vector<double> values;
  };

  bool take(std::size_t depth, std::size_t column);
  bool extend(std::size_t depth, std::size_t next);
  bool can_be_completed(std::size_t depth, std::size_t next);
  bool is_zero(double value, std::size_t column) const;

  std::vector<int> columns_;  ///< required first, then allowed: index of each in the matrix
  std::size_t required_ = 0;
  std::size_t width_ = 0;      ///< number of columns_
  std::size_t height_ = 0;     ///< number of rows, of the columns to choose
  std::vector<double> least_;  ///< of each of columns_: the size that counts
  std::vector<Level> levels_;
  std::vector<int> chosen_;
  std::uint64_t work_ = 0;
  std::uint64_t most_work_ = 0;
  const std::function<bool(const std::vector<int>&)>* found_ = nullptr;
};

}  // namespace kinestat
