// Lists of random screws for couplings of type screws.
#pragma once

#include "support/random_network_catalogue.hpp"

namespace kinestat {

/// Freedoms alone, constraints alone, or some of both that are reciprocal (all of them, where the
/// coupling is to be complementary). The screws of a list are independent.
std::vector<NetworkKey> draw_screw_lists(Completeness completeness, LayoutDraw& draw);

}  // namespace kinestat
