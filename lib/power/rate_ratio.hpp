// The arithmetic of transmission ratios.
#pragma once

#include <optional>
#include <span>

namespace kinestat {

/// The rate that all inputs have in common; empty if the rates differ. There must be at least one.
std::optional<double> common_rate(std::span<const double> rates);

/// The quotient `above` / `below`; empty if `below` is zero or if either has no value.
std::optional<double> share_of(std::optional<double> above, std::optional<double> below);

}  // namespace kinestat
