// An answer that a check made before has promised.
#pragma once

#include <optional>

#include "core/contract.hpp"

namespace kinestat {

/// What is in the answer; that it is empty is a fault of the program.
template <class Item>
Item expect(const std::optional<Item>& answer) {
  KINESTAT_EXPECTS(answer.has_value());
  return *answer;
}

}  // namespace kinestat
