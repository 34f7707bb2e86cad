// A row of a sweep with what decides whether it is kept.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "studies/sweep/best_choice.hpp"

namespace kinestat {

/// What a row is worth by each criterion, the more the better; 0 beyond the last one.
using RankKeys = std::array<double, kMostCriteria>;

/// The key of a value: without the last twelve or so of its 53 bits, which are rounding, so that
/// what is the same by the formulas of a mechanism ties. A difference has the rounding of its
/// terms, whose size is `terms`.
double rank_key(double value, RankOrder order, double terms = 0.0);

struct RankedRow {
  RankKeys keys = {};
  std::uint64_t number = 0;  ///< in the order of the sweep
  std::string text;          ///< any bytes
};

/// By the first key that differs; of equal rows the one that comes first in the sweep, so that a
/// choice does not depend on who finds it when.
bool is_better(const RankKeys& a,
               std::uint64_t number_a,
               const RankKeys& b,
               std::uint64_t number_b);
bool is_better(const RankedRow& a, const RankedRow& b);

/// Rows as text from which read_rows makes them again, to the last bit of their keys.
std::string write_rows(const std::vector<RankedRow>& rows);

/// What is no such text has no rows.
std::vector<RankedRow> read_rows(const std::string& text);

}  // namespace kinestat
