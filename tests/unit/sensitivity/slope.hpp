// Slopes by one parameter in the tests of this folder.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace kinestat {

using Slopes = std::vector<std::optional<double>>;

/// No number where there is no slope.
inline double slope(const Slopes& slopes, std::size_t parameter) {
  return slopes.at(parameter).value_or(NAN);
}

}  // namespace kinestat
