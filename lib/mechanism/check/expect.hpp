// A value that an earlier check guarantees.
#pragma once

#include <optional>

#include "core/contract.hpp"

namespace kinestat {

/// The value of an optional, which must not be empty.
template <class Item>
Item expect(const std::optional<Item>& answer) {
  KINESTAT_EXPECTS(answer.has_value());
  return *answer;
}

}  // namespace kinestat
