// What a fuzz target asserts: in every build, and with the words that say what broke.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string_view>

namespace kinestat::fuzz {

/// Ends the process with a core if the invariant does not hold. `evidence` is shown as it is.
inline void require(bool holds, std::string_view invariant, std::string_view evidence = "") {
  if (holds) {
    return;
  }
  std::fprintf(stderr,
               "broken: %.*s\n  %.*s\n",
               static_cast<int>(invariant.size()),
               invariant.data(),
               static_cast<int>(evidence.size()),
               evidence.data());
  std::abort();
}

/// The same of evidence that is costly to put together.
template <std::invocable Evidence>
void require(bool holds, std::string_view invariant, const Evidence& evidence) {
  if (!holds) {
    require(holds, invariant, std::string_view(evidence()));
  }
}

/// A number that a text has every time, to choose by.
inline std::size_t sum_of(std::string_view text) {
  return std::accumulate(text.begin(), text.end(), text.size(), [](std::size_t sum, char one) {
    return sum + static_cast<unsigned char>(one);
  });
}

}  // namespace kinestat::fuzz
