// The cases of a description in numbers.
#pragma once

#include <span>
#include <vector>

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Resolves what the cases refer to and evaluates what they give, which may follow the curves.
std::vector<Case> bind_cases(const MechanismDescription& description,
                             const Topology& topology,
                             std::span<const Curve> curves,
                             Evaluator& evaluator,
                             Diagnostics& found);

}  // namespace kinestat
