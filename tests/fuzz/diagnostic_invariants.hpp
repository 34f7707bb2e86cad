// What must hold of every message about a text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"
#include "expression/expression_error.hpp"

namespace kinestat::fuzz {

/// The lengths of a text's lines in characters, without their ends and the byte order mark.
class LineLengths {
 public:
  explicit LineLengths(std::string_view text);

  /// Whether the place is the whole file, or begins and ends within one line. One character behind
  /// the end of a line is allowed: that is where something is missing.
  bool holds(const SourceRange& where) const;

 private:
  std::vector<int> lengths_;
};

/// Codes are known, places lie in the text, messages are lines of printable text.
void check_diagnostics(const Diagnostics& found, const LineLengths& lines);

/// Code and place of what is wrong with an expression or a unit; its words become a diagnostic's.
void check_error(const ExpressionError& error, std::string_view text);

}  // namespace kinestat::fuzz
