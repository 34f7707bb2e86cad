// The inertia that the input of a solved case feels.
#pragma once

#include <optional>
#include <vector>

#include "cases/analysis.hpp"

namespace kinestat {

/// The freedom of the one input of a case; empty where it has none or several.
std::optional<int> only_input_freedom(const Mechanism& mechanism, const Case& which);

/// Of each body what it adds to the equivalent inertia or mass there, as `equivalent_inertias` has
/// it; empty without such an input or a solved motion.
std::optional<std::vector<double>> input_inertias(const Mechanism& mechanism,
                                                  const CaseAnalysis& one);

}  // namespace kinestat
