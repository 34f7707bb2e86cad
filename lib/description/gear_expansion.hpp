// What gear trains in teeth add to the couplings of a mechanism.
#pragma once

#include "description/mechanism_description.hpp"

namespace kinestat {

/// Appends for each mesh, in the order of the file, a coupling of type `gear` from the body of its
/// first member to that of its second. In the plane, revolute couplings, clutches and brakes of a
/// body that has a member or is a carrier, or that clutches join to one, and that say nothing of
/// their place, come to stand on the axis of that body; those of a body that does nothing but turn,
/// on the main axis.
///
/// To be done once, after reading and before expand_cables, because couplings come first, then
/// meshes, then cables. Nothing is added if a mesh joins what the file does not declare or a body
/// to itself, or if its name is taken: binding complains of all these.
void expand_gears(MechanismDescription& description);

/// Whether all meshes have become couplings, or there are none.
bool has_all_meshes(const MechanismDescription& description);

/// The same without the couplings that meshes became.
MechanismDescription without_meshes(const MechanismDescription& description);

/// The member of that name, or null.
const GearMember* find_member(const GearsDescription& gears, const Name& name);

/// The body that holds the centres of a mesh apart: its carrier, else the ground.
const std::string& carrier_of(const MeshDescription& mesh, const MechanismDescription& description);

}  // namespace kinestat
