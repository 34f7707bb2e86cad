// Two reports, value by value.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/compare/compare_tolerance.hpp"
#include "studies/compare/compare_values.hpp"

namespace kinestat {

enum class DifferenceType {
  number,     ///< two numbers that differ by more than the tolerance
  text,       ///< two texts, or a text and a number
  no_value,   ///< one report has a value or several, the other null or nothing: an empty cell or
              ///< list
  unit,       ///< two numbers whose units do not measure the same, or are not told
  only_in_a,  ///< the place, with all below it, is in one report only
  only_in_b
};

/// The word that reports of comparisons use: "number", "no value", "only in A" and so on.
std::string_view word_of(DifferenceType type);

struct Difference {
  DifferenceType type = DifferenceType::number;
  std::string place;
  std::optional<ReportValue> a;
  std::optional<ReportValue> b;  ///< a number in the unit of A, where it can be converted
  std::size_t count = 1;         ///< of a place in one report only: the values at it and below
  double amount = 0.0;           ///< of two numbers: |a - b|
  double allowed = 0.0;          ///< of two numbers: the tolerance
  ValueUnit unit;                ///< of A, or of B where A has no number
  std::string other_unit;        ///< of B, where it cannot be converted
};

struct ReportComparison {
  std::size_t value_count = 0;  ///< places that either report has
  std::vector<Difference> differences;
  std::vector<std::string> unmet_places;  ///< of tolerances: neither report has a value there
};

/// Compares two reports of one form by the places of their values; the order of the values does not
/// matter. Numbers are compared in the unit of A. Differences come in the order of A, then those
/// that only B has in the order of B.
ReportComparison compare(const ReportValues& a,
                         const ReportValues& b,
                         const Tolerances& tolerances);

}  // namespace kinestat
