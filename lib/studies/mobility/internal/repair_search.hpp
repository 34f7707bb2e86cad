// Finds sets of changes, each added freedom of which works on a self-stress of its own.
#pragma once

#include <vector>

#include "studies/mobility/repair.hpp"

namespace kinestat {

/// Up to `most` sets that remove all the constraints, the cheapest first.
std::vector<std::vector<CouplingChange>> search_changes(
    const Mechanism& mechanism, const std::vector<RedundantConstraint>& constraints, int most);

}  // namespace kinestat
