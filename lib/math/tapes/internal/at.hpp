// Element of a container by a plain int.
#pragma once

#include <cstddef>

namespace kinestat {

template <class Container>
decltype(auto) at(Container& container, int i) {
  return container[static_cast<std::size_t>(i)];
}

}  // namespace kinestat
