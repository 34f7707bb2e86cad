// Masses and inertias of a description in numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mechanism/check/section_context.hpp"
#include "mechanism/inertia/body_mass.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Mass and inertia of a body of the description, by its index.
struct DescribedMass {
  std::size_t body = 0;
  BodyMass mass;
};

/// Of the bodies that have any, places from the origin of the evaluator. Complains of moments that
/// no body has (E0322), and of masses without a centre where a case has inertia, unless gears turn
/// the body about a known axis.
std::vector<DescribedMass> bind_masses(const SectionContext& context);

/// Whether gears turn a body about an axis of their train, on which its centre is by default.
bool is_on_axis(const MechanismDescription& description, const std::string& body);

/// The same for each body of the topology: with the centres of gears on their axes and the planets
/// counted. Warns of radii of gyration that do not suit the size of the mechanism (W0311).
std::vector<BodyMass> masses_of_bodies(const SectionContext& context,
                                       const Mechanism& mechanism,
                                       const std::vector<DescribedMass>& masses);

/// The coupling at whose point the centre of a gear is that has none of its own.
std::optional<CouplingId> centre_bearing(const MechanismDescription& description,
                                         const Topology& topology,
                                         BodyId body);

}  // namespace kinestat
