// The geometry of one coupling: what its type needs, checked and in numbers.
#pragma once

#include <optional>

#include "mechanism/internal/evaluator.hpp"

namespace kinestat {

/// The numbers of a coupling; complains about what its type lacks or cannot use.
std::optional<CouplingGeometry> bind_geometry(const CouplingDescription& coupling,
                                              Space space,
                                              Evaluator& evaluator,
                                              Diagnostics& found);

/// Keeps only the constraints that `passive:` names; complains about names that the coupling does
/// not have.
void keep_passive(const CouplingDescription& coupling, CouplingScrews& screws, Diagnostics& found);

}  // namespace kinestat
