// An expression's text cut into numbers, names and symbols.
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "expression/expression_error.hpp"

namespace kinestat {

enum class TokenKind { number, name, symbol, end };

struct Token {
  TokenKind kind = TokenKind::end;
  int offset = 0;      ///< [bytes]
  int length = 0;      ///< [bytes] 0 at the end
  double value = 0.0;  ///< of a number
};

/// The tokens of a text, the last of kind `end`. A symbol is any single printable ASCII character;
/// which ones may stand is the parser's business. Errors: E0308 for numbers that are not plain
/// decimals or that no double holds, and for characters outside printable ASCII.
std::variant<std::vector<Token>, ExpressionError> scan(std::string_view text);

}  // namespace kinestat
