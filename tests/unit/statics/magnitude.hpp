// Actions by their names in the tests of this folder.
#pragma once

#include <cmath>
#include <string_view>

#include "statics/action.hpp"
#include "support/mechanism_text.hpp"

namespace kinestat {

/// The magnitude of an action, or no number where it is open.
inline double magnitude(const Mechanism& mechanism,
                        const StaticSolution& solution,
                        std::string_view name) {
  const auto a = static_cast<std::size_t>(action_index(mechanism, name));
  return solution.magnitudes.at(a).value_or(std::nan(""));
}

}  // namespace kinestat
