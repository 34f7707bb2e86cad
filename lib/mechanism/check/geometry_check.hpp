// Whether a coupling has what its type needs, apart from directions.
#pragma once

#include "mechanism/bind/evaluator.hpp"

namespace kinestat {

/// A coupling without a point whose type needs one, or a cable without ends: its file can only be
/// counted.
bool is_counted_only(const CouplingDescription& coupling);

/// Whether the coupling may stand in that space, has the ends, pitch or screws that its type needs,
/// and the numbers of its stiffness are right. Adds errors if not. Points and
/// directions are checked when they are bound.
bool check_geometry(const CouplingDescription& coupling,
                    Space space,
                    Evaluator& evaluator,
                    Diagnostics& found);

}  // namespace kinestat
