// Why a file cannot be written, as an error.
#pragma once

#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/diagnostic.hpp"

namespace kinestat {

inline void refuse_writing(const std::string& path, std::string_view why, Diagnostics& found) {
  found.error("E0152", {}, fmt::format("cannot write '{}': {}", path, why));
}

/// With the number of an error of the system.
inline void refuse_writing(const std::string& path, int error, Diagnostics& found) {
  refuse_writing(path, std::generic_category().message(error), found);
}

}  // namespace kinestat
