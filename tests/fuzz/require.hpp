// What a fuzz target asserts: in every build, and with the words that say what broke.
#pragma once

#include <cstdio>
#include <cstdlib>
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

}  // namespace kinestat::fuzz
