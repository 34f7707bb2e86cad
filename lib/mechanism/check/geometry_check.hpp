// Checks of the places and numbers of couplings, except their directions.
#pragma once

#include "core/diagnostic.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/gears/internal/gear_binder.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Whether a coupling lacks a point that its type needs, or is a cable without ends, so that its
/// file can only be counted.
bool is_counted_only(const CouplingDescription& coupling);

/// Whether the type of a coupling is allowed in this space, the coupling has the ends, pitch or
/// screws that its type needs, and the numbers of its stiffness are right. Adds errors if not.
/// Points and directions are checked when they are bound.
bool check_geometry(const CouplingDescription& coupling,
                    Space space,
                    Evaluator& evaluator,
                    Diagnostics& found);

/// Whether the place of a coupling is allowed. A place on an axis, given by a single number, is an
/// error in a file without `gears`, in the plane, where an axis is a point, and for a coupling
/// between two planets. `gears` is null if there are none or if they are wrong.
bool check_axis_place(const CouplingDescription& coupling,
                      const MechanismDescription& description,
                      const GearFrame* gears,
                      Diagnostics& found);

/// Adds W0309 for every moving body whose only couplings are two revolutes on one axis. A coupling
/// without a place has none.
void warn_of_links_without_length(const MechanismDescription& description,
                                  const Mechanism& mechanism,
                                  Diagnostics& found);

}  // namespace kinestat
