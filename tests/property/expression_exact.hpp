// The exact value of a random expression, by another way than the library's.
#pragma once

#include <optional>
#include <span>

#include "property/expression_sample.hpp"

namespace kinestat::sample {

/// The value as a fraction times a power of pi, from the meanings of its parts.
std::optional<ExactValue> exact_value(const Tree& tree, std::span<const Meaning> parts);

}  // namespace kinestat::sample
