// The cases of a description in numbers.
#pragma once

#include <span>
#include <vector>

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Binds the cases: resolves their references and evaluates their numbers, which may follow curves.
std::vector<Case> bind_cases(const MechanismDescription& description,
                             const Topology& topology,
                             std::span<const Curve> curves,
                             Evaluator& evaluator,
                             Diagnostics& found);

}  // namespace kinestat
