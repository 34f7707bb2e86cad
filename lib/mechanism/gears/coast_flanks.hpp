// On which flanks teeth press.
#pragma once

#include <functional>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace kinestat {

/// The force of an action along its line, positive as the file writes it; zero where it is unknown.
using ForceOf = std::function<double(int action)>;

/// The teeth that press on their coast flanks under forces along their lines of action, as indices
/// into Geometry::other_flanks: where a force is negative, and where it is zero those of `before`.
std::vector<int> coast_flanks_under(const Geometry& geometry,
                                    const std::vector<int>& before,
                                    const ForceOf& force_of);

/// The actions of teeth that pull on each other, pressing on the flanks `coast` and the others as
/// drawn: as they have no other flank that is known, or none on which they would stay.
std::vector<int> pulling_teeth(const Mechanism& mechanism,
                               const std::vector<int>& coast,
                               const ForceOf& force_of);

}  // namespace kinestat
