// Powers and functions with a hundred digits, for numbers of which no exact value is known.
#pragma once

#include <optional>
#include <string_view>

#include "expression/expression.hpp"
#include "math/numbers/big_float.hpp"

namespace kinestat {

/// A decimal as typed. Empty beyond the range of BigFloat.
std::optional<BigFloat> precise_number(std::string_view literal);

/// Of a power or a function; as NumberTraits::apply. Empty where there is no finite value, though
/// the double may have one by its rounding.
std::optional<BigFloat> apply_precisely(const Node& operation,
                                        const BigFloat& a,
                                        const BigFloat& b);

}  // namespace kinestat
