// What to type instead of a name that is not known.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kinestat {

/// "did you mean 'deg'?", the size of a unit that is not known here ("1 ms is 0.001 s"), or the
/// list of units when nothing is near.
std::string unit_hint(std::string_view word);

/// "did you mean 'N1'?" among the names given, then functions, units and pi; may be empty.
std::string name_hint(std::string_view word, std::span<const std::string> known);

/// "did you mean 'sin'?", or the list of functions when nothing is near.
std::string function_hint(std::string_view word);

}  // namespace kinestat
