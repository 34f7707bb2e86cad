// The rows of a sweep as those of an array of NumPy.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "studies/sweep/report/sweep_rows.hpp"

namespace kinestat {

/// The fields of a row, as npy_dtype has them, called by the titles of the columns. Parameters that
/// run through bare whole numbers alone are whole numbers, and so are case and status: which of the
/// cases of the sweep, and which of sweep_statuses. Numbers and not words, because columns of
/// categories are made of them as they are, where each word would have to be read; and of eight
/// bytes, because every field then lies where its type wants it.
std::string sweep_dtype(const SweepPlan& plan, std::span<const SweepColumn> columns);

/// Writes rows as such an array has them. A quantity without a value is a NaN.
class SweepRowArray {
 public:
  SweepRowArray(const SweepPlan& plan, std::span<const SweepColumn> columns);

  /// Takes the places of a state on the axes, which its rows then begin with.
  void enter(std::span<const std::uint64_t> places);

  /// Appends the row of a case of that state.
  void append(const SweepRow& row, std::string& rows);

 private:
  const SweepPlan& plan_;
  std::vector<char> is_whole_;         ///< of each axis
  std::vector<std::uint64_t> places_;  ///< of the state
  std::vector<std::uint64_t> fields_;  ///< of the row
};

}  // namespace kinestat
