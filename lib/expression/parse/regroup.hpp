// The grouping that was meant by a fraction before a unit: (13/27) N for 13/27 N.
#pragma once

#include <optional>
#include <string>

#include "expression/expression.hpp"

namespace kinestat {

/// The expression with parentheses around each quotient whose divisor is a number with a unit and
/// whose dividend has none. Empty if there is no such quotient. Offsets are those of the new text.
std::optional<Expression> regrouped(const Expression& expression);

/// "a unit belongs to the number right before it: write (13/27) N*m".
std::string regrouping_hint(const Expression& better);

}  // namespace kinestat
