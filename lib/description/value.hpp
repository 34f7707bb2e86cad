// Names and numbers as the user typed them, with their places.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/source.hpp"
#include "expression/expression.hpp"

namespace kinestat {

struct Name {
  std::string text;
  SourceRange where;
};

/// A number or expression, kept as typed; binding evaluates it.
struct Value {
  Expression expression;
  SourceRange where;
  int text_column = 0;  ///< column where the expression's text begins on its line; 0: unknown
};

/// A point [length] or another vector: two coordinates in the plane, three in space.
struct PointDescription {
  std::vector<Value> coordinates;
  SourceRange where;
};

/// A direction: `x`, `-z`, … or a vector of plain numbers.
struct AxisDescription {
  char keyword = 0;   ///< 'x', 'y', 'z', or 0: then `components` hold the vector
  double sign = 1.0;  ///< of the keyword
  std::vector<Value> components;
  SourceRange where;
};

/// Where a part of a scalar's text stands in the file. `offset` and `length` count bytes of `text`;
/// the whole scalar `where` is the answer if `text_column` is 0 (a text over several lines) or if
/// nothing is marked out (offset and length 0).
SourceRange place_in(
    SourceRange where, int text_column, std::string_view text, int offset, int length);

/// Where the error of an expression stands in the file.
SourceRange place_in(const Value& value, const ExpressionError& error);

}  // namespace kinestat
