// Masses and inertias of a description in numbers.
#pragma once

#include <vector>

#include "mechanism/check/section_context.hpp"
#include "mechanism/inertia/body_mass.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Of each body of the description, places from the origin of the evaluator. Complains of moments
/// that no body has (E0322), and of masses without a centre where a case has inertia, unless gears
/// turn the body about a known axis.
std::vector<BodyMass> bind_masses(const SectionContext& context);

/// The same for each body of the topology: with the centres of gears on their axes and the planets
/// counted. Warns of radii of gyration that do not suit the size of the mechanism (W0311).
std::vector<BodyMass> masses_of_bodies(const SectionContext& context,
                                       const Mechanism& mechanism,
                                       const std::vector<BodyMass>& masses);

}  // namespace kinestat
