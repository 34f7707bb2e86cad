// The rows of codes.hpp that are warnings.
#pragma once

#include <span>

#include "core/codes.hpp"

namespace kinestat {

/// Sorted by code.
std::span<const Code> warning_codes();

}  // namespace kinestat
