// How long and how deep an expression may be.
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "expression/expression_error.hpp"

namespace kinestat {

inline constexpr std::size_t kLongestText = 4096;  // [bytes]
inline constexpr int kDeepestNesting = 64;

/// E0210 for a text above the limit. `what` is "expression" or "condition".
inline std::optional<ExpressionError> find_too_long(std::string_view text, std::string_view what) {
  if (text.size() <= kLongestText) {
    return std::nullopt;
  }
  return ExpressionError{
      .offset = 0,
      .length = static_cast<int>(kLongestText),
      .code = "E0210",
      .message = fmt::format("the {} is longer than {} bytes", what, kLongestText),
      .hint = "divide it among parameters"};
}

}  // namespace kinestat
