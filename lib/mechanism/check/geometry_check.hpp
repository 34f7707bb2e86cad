// What is wrong with where couplings are and what they are given, directions apart.
#pragma once

#include "core/diagnostic.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/gears/internal/gear_binder.hpp"
#include "mechanism/mechanism.hpp"

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

/// Whether a coupling may stand where it does. Complains of a single number in a file without
/// `gears`, in the plane, where an axis is a point, and of a coupling between two planets. `gears`
/// is null if there are none or if they are wrong.
bool check_axis_place(const CouplingDescription& coupling,
                      const MechanismDescription& description,
                      const GearFrame* gears,
                      Diagnostics& found);

/// Warns of every moving body that two revolutes on one axis join to others, and nothing else:
/// W0309.
void warn_of_links_without_length(const Mechanism& mechanism, Diagnostics& found);

}  // namespace kinestat
