// The friction of a coupling in numbers.
#pragma once

#include <optional>

#include "couplings/coupling_geometry.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/couplings/coupling_friction.hpp"

namespace kinestat {

/// Whether friction of this type of coupling is analysed.
bool has_friction_law(const CouplingDescription& coupling);

/// The numbers of the friction of a coupling that has some, without a look at what they mean.
/// `Scalar` is double or Dual.
template <class Scalar>
CouplingFrictionOf<Scalar> read_friction(const CouplingDescription& coupling,
                                         CouplingId id,
                                         const FileUnits& units,
                                         EvaluatorOf<Scalar>& evaluator,
                                         Diagnostics& found);

/// The numbers of the friction; complains of those that are negative, and of a coefficient where
/// nothing presses: `screws` are what the coupling frees and bears. The coupling must have
/// `friction`. Empty iff an error was added, or if there is no law.
std::optional<CouplingFriction> bind_friction(const CouplingDescription& coupling,
                                              CouplingId id,
                                              const CouplingScrews& screws,
                                              const FileUnits& units,
                                              Evaluator& evaluator,
                                              Diagnostics& found);

}  // namespace kinestat
