// The order in which parameters can be evaluated, and the circles that have none.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "expression/parameters.hpp"

namespace kinestat {

struct ParameterOrder {
  std::vector<int> order;               ///< each after those that it uses, without the circles
  std::vector<ParameterError> circles;  ///< E0310, each at its first parameter
};

/// `index_of` answers the index of a name, or -1.
ParameterOrder find_order(std::span<const Parameter> parameters,
                          const std::function<int(std::string_view)>& index_of);

}  // namespace kinestat
