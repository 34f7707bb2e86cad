// The contacts of cables with pulleys, and their friction.
#pragma once

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Fills mechanism.contacts, in the order of the cables and of their stations, and adds the
/// friction of cables to mechanism.frictions: where a cable slips with `friction` or `eta`, to the
/// coupling of its virtual link; where a pulley has `eta`, to the revolute coupling on which it
/// turns, whose lack is an error if the cable cannot slip. The cables must be right and expanded,
/// the couplings bound.
void bind_contacts(const MechanismDescription& description,
                   Evaluator& evaluator,
                   Diagnostics& found,
                   Mechanism& mechanism);

}  // namespace kinestat
