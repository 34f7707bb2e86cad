// By how much the values of two reports may differ.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"
#include "core/tolerance.hpp"
#include "studies/compare/compare_values.hpp"

namespace kinestat {

/// The options of the command line as they were typed; an empty text is an option that was not
/// given.
struct ToleranceTexts {
  std::string rtol;
  std::string atol;
  std::vector<std::string> tolerances;  ///< KEY=VALUE
};

/// What holds for the values of one kind, or at one place and below, in place of the general
/// tolerances.
struct ToleranceRule {
  std::string key;  ///< "moment", or "/cases/*/ratio"
  double value = 0.0;
  bool is_relative = false;            ///< a share of the larger value
  std::optional<Dimension> dimension;  ///< of a value in SI; none: it counts in the unit of A

  /// Whether the key is a pattern of places, and not a kind.
  bool is_place() const { return key.starts_with('/'); }
};

struct Tolerances {
  double relative = kReportsAgree;  ///< of the larger of the two
  std::optional<double> absolute;   ///< in the unit of A; none: kReportsAgreeBesideLargest
  std::vector<ToleranceRule> rules;
};

/// Reads the options. Wrong ones are errors of the command line (E0101); empty iff there are any.
std::optional<Tolerances> read_tolerances(const ToleranceTexts& texts, Diagnostics& found);

/// Two numbers at one place, both in the unit of the first report.
struct NumberPair {
  std::string_view place;
  double a = 0.0;
  double b = 0.0;
  const ValueUnit& unit;
  double largest = 0.0;  ///< magnitude among the numbers of this kind in the same case
};

/// The difference that is still equal, in the unit of the pair. The last rule that fits decides;
/// without one it is the larger of the relative and the absolute tolerance, and zero for counts.
double allowed_difference(const NumberPair& pair, const Tolerances& tolerances);

/// Whether the two are equal. A difference of exactly the tolerance is: the rounding of the two
/// numbers and of the tolerance does not count. The tolerance 0 asks for the same number.
bool are_equal(const NumberPair& pair, double allowed);

}  // namespace kinestat
