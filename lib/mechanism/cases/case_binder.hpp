// The cases of a description in numbers.
#pragma once

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Resolves what the cases refer to and evaluates what they give.
std::vector<Case> bind_cases(const MechanismDescription& description,
                             const Topology& topology,
                             Evaluator& evaluator,
                             Diagnostics& found);

}  // namespace kinestat
