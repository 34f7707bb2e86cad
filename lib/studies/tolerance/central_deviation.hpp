// Deviations of hinges on the axis of several equal planets, of which one is drawn.
#pragma once

#include <span>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "studies/tolerance/deviation.hpp"

namespace kinestat {

/// The vector g of which u_i · g are these influences, within the span of the directions u_i.
Vec3 influence_vector(const std::vector<Vec3>& directions, const std::vector<double>& influences);

/// As the forces of equal planets cancel on central hinges (CentralHinge), so do the influences of
/// where these stand: a sun that is off goes nearer to one planet and away from the others. Takes
/// what cancels from `by_parts`, the influence of each deviation under these unit loads; deviations
/// that do not fit are left as they are.
void cancel_planets(const Mechanism& mechanism,
                    std::span<const BodyWrench> unit_loads,
                    std::span<const Deviation> deviations,
                    const std::vector<bool>& fits,
                    std::vector<double>& by_parts);

}  // namespace kinestat
