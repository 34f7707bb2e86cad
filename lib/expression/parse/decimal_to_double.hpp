// From the text of a number to a double, for every number of a file; math/numbers/rational reads
// the same text to a fraction.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace kinestat {

/// Where the decimal that begins at `at` ends: digits, point, digits, exponent.
std::size_t end_of_decimal(std::string_view text, std::size_t at);

/// The double nearest to a decimal without sign. Empty if no double holds the number: then
/// `out_of_range` is 0 or infinity.
std::optional<double> double_of(std::string_view literal, double& out_of_range);

/// The value of a text that is one decimal with an optional sign and nothing else; empty for
/// everything that needs a closer look.
std::optional<double> read_plain_number(std::string_view text);

}  // namespace kinestat
