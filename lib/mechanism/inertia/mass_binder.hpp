// The masses and inertias of a description, bound to numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mechanism/check/section_context.hpp"
#include "mechanism/inertia/body_mass.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Mass and inertia of the body of the description with this index.
struct DescribedMass {
  std::size_t body = 0;
  BodyMass mass;
};

/// Binds the masses of all bodies that have any. Places are measured from the origin of the
/// evaluator. Adds errors for moments of inertia that no body can have (E0322) and, if a case has
/// inertia, for masses without a centre, unless gears turn the body about a known axis.
std::vector<DescribedMass> bind_masses(const SectionContext& context);

/// Whether gears turn a body about an axis of their train. Its centre of mass is then on this axis
/// by default.
bool is_on_axis(const MechanismDescription& description, const std::string& body);

/// The masses of each body of the topology, with the centres of gears on their axes and with the
/// counts of planets. Warns of radii of gyration that do not suit the mechanism (W0311).
std::vector<BodyMass> masses_of_bodies(const SectionContext& context,
                                       const Mechanism& mechanism,
                                       const std::vector<DescribedMass>& masses);

/// The coupling at whose point a gear has its centre of mass if the file gives it no centre.
std::optional<CouplingId> centre_bearing(const MechanismDescription& description,
                                         const Topology& topology,
                                         BodyId body);

}  // namespace kinestat
