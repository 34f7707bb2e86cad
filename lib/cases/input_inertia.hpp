// The equivalent inertia of all bodies at the input of a solved case.
#pragma once

#include <optional>
#include <vector>

#include "cases/analysis.hpp"

namespace kinestat {

/// The freedom of the input of a case; empty if it has no input or several.
std::optional<int> only_input_freedom(const Mechanism& mechanism, const Case& which);

/// The contribution of each body to the equivalent moment of inertia [kg·m²], or mass [kg], at the
/// input, as by `equivalent_inertias`; also of a case in which all drives rest. Empty without one
/// input or without a solved motion.
std::optional<std::vector<double>> input_inertias(const Mechanism& mechanism,
                                                  const CaseAnalysis& one);

}  // namespace kinestat
