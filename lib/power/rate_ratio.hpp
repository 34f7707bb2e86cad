// The arithmetic of transmission ratios.
#pragma once

#include <optional>
#include <span>

namespace kinestat {

/// The rate of all inputs, of which there is one at least; empty if they differ.
std::optional<double> common_rate(std::span<const double> rates);

/// Empty where `below` is zero, or either has no value.
std::optional<double> share_of(std::optional<double> above, std::optional<double> below);

}  // namespace kinestat
