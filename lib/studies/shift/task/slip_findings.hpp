// The changes of gear whose slip a file asks for, and what is wrong with them.
#pragma once

#include "cases/analysis.hpp"
#include "core/diagnostic.hpp"

namespace kinestat {

/// Follows each slip of the plan; one that does not end as asked is a warning (W0713).
void add_slips(const MechanismDescription& description,
               const Mechanism& mechanism,
               ShiftAnalysis& shift,
               Diagnostics& found);

}  // namespace kinestat
