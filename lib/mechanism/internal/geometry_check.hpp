// The geometry keys of a coupling that its catalogue row does not turn into screws.
#pragma once

#include "mechanism/internal/evaluator.hpp"

namespace kinestat {

/// A coupling without a point whose type needs one: its file can only be counted.
bool is_counted_only(const CouplingDescription& coupling);

/// Whether the coupling may stand in that space, has the keys that its type needs, and all their
/// numbers are right; friction and stiffness included. Adds errors if not. Types of the catalogue
/// have their points and axes checked when they are bound.
bool check_geometry(const CouplingDescription& coupling,
                    Space space,
                    Evaluator& evaluator,
                    Diagnostics& found);

}  // namespace kinestat
