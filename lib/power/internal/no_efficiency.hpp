// The efficiency of what has none.
#pragma once

#include <string>
#include <utility>

#include "power/efficiency.hpp"

namespace kinestat {

/// No value, and why.
inline Efficiency no_efficiency(std::string reason) {
  return {.value = std::nullopt, .reason = std::move(reason)};
}

}  // namespace kinestat
