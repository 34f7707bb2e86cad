// What reports say of where the power goes.
#pragma once

#include "power/power_record.hpp"

namespace kinestat {

/// Adds arcs, bodies, meshes and circulating power.
void add_power_graph(Record<PowerView>& keys);

}  // namespace kinestat
