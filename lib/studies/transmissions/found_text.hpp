// What a search has found of a structure, as a text that keeps every bit.
#pragma once

#include <optional>
#include <string>

#include "studies/transmissions/search.hpp"

namespace kinestat {

/// Lines of numbers: the stages, then one transmission each.
std::string write_found(const TransmissionSearch& search);

/// Empty for any other text.
std::optional<TransmissionSearch> read_found(const std::string& text);

}  // namespace kinestat
