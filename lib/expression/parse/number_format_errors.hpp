// Numbers in the notations of other places, which must not be read as something else.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "expression/expression_error.hpp"

namespace kinestat {

/// What is wrong with the number whose decimal digits reach from `begin` to `end`, if they go on as
/// no decimal does: 0x1F, 1_000, 12:30, 1.2.3, 017. Errors: E0308, here and below.
std::optional<ExpressionError> find_foreign_number(std::string_view text,
                                                   std::size_t begin,
                                                   std::size_t end);

/// What is wrong with "1 000": a whole number from `begin` on, blanks, and three digits at `at`.
std::optional<ExpressionError> find_spaced_number(std::string_view text, int begin, std::size_t at);

/// What is wrong with 1,5 or 1,000.5: two numbers with a comma between them.
ExpressionError decimal_comma(std::string_view text, int begin, int end);

/// What is wrong with a number that no double holds.
ExpressionError number_out_of_range(std::string_view text,
                                    std::size_t begin,
                                    std::size_t end,
                                    bool is_tiny);

/// What is wrong with .nan and .inf.
ExpressionError not_finite(std::string_view text, std::size_t begin, std::size_t end);

}  // namespace kinestat
