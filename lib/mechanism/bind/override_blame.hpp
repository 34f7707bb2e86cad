// Mistakes of a file that are of values on the command line.
#pragma once

#include <functional>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"

namespace kinestat {

/// What binds a description, for its complaints.
using Binding = std::function<void(const MechanismDescription&, Diagnostics&)>;

/// Whether the command line gave a parameter another value.
bool has_overrides(const MechanismDescription& description);

/// Adds to `found` what was `said` of a description. An error that the file has not with its own
/// values becomes one of the option, E0102; a note has the place where the value is used, and what
/// may stand there.
void add_blaming_overrides(const MechanismDescription& description,
                           const Binding& bind,
                           const Diagnostics& said,
                           Diagnostics& found);

}  // namespace kinestat
