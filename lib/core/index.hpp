// An int as an index of a standard container.
#pragma once

#include <cstddef>

namespace kinestat {

/// The place in a standard container that an int, which must not be negative, numbers.
inline std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

}  // namespace kinestat
