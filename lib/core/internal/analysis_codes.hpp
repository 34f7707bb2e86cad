// The rows of codes.hpp that are errors of analysis and studies.
#pragma once

#include <span>

#include "core/codes.hpp"

namespace kinestat {

/// From E0401 on, sorted by code.
std::span<const Code> analysis_codes();

}  // namespace kinestat
