// Links that have no length.
#pragma once

#include "core/diagnostic.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Warns of every moving body that two revolutes on one axis join to others, and nothing else:
/// W0309.
void warn_of_links_without_length(const Mechanism& mechanism, Diagnostics& found);

}  // namespace kinestat
