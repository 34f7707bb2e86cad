// What is wrong with an expression, and where in its text.
#pragma once

#include <string>
#include <string_view>

namespace kinestat {

/// Offset and length count bytes of the expression's text; length 0 stands for the place itself.
/// `code` is a row of core/codes; message and hint are worded as in Diagnostic.
struct ExpressionError {
  int offset = 0;
  int length = 0;
  std::string_view code;
  std::string message;
  std::string hint;
};

}  // namespace kinestat
