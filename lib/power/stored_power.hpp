// Loads that store energy: what they take they give back later.
#pragma once

#include <string>

#include "mechanism/cases/load.hpp"

namespace kinestat {

/// Why there is no efficiency where this load exchanges power; empty of a load that stores nothing.
std::string stored_power_reason(const Load& load);

}  // namespace kinestat
