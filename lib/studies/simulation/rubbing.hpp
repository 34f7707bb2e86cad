// What rubs in a simulation.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

/// What a mesh loses while it drives one of its gears: a couple against how that turns in the
/// carrier, a share of the power that rolls into it over its speed. Of the other gear it is zero.
struct DrivenGear {
  BodyPair between;  ///< carrier and gear
  bool is_head = true;
  const LossyMesh* mesh = nullptr;  ///< in the mechanism; its share follows from the speed alone
  double radius = 0.0;              ///< of its pitch circle [m]
  double sense = 1.0;               ///< of the screw of the first hinge along the axis of the gear
};

/// A part of a sliding: the rate of a freedom times a factor.
struct SlidingTerm {
  int freedom = 0;  ///< index into Topology::freedoms
  double factor = 1.0;
};

/// The friction of a coupling of one freedom, or what a mesh loses on one of its gears.
struct Rubbing {
  CouplingId coupling;              ///< that rubs, or whose teeth do
  std::vector<SlidingTerm> slides;  ///< of hinges on the axis of the gear, from the carrier to it
  CouplingFriction friction = {};   ///< not of a mesh
  std::optional<DrivenGear> gear = {};

  /// Whether some of it is there however slow it slides: it sticks and slips.
  bool is_dry() const;

  /// Whether it is that of a cable on the virtual link on which it slips.
  bool is_slip() const { return !friction.cables.empty() && friction.cables.front().slips; }

  /// Whether it is that of nothing but cables that may slip instead.
  bool is_of_gripped() const;

  /// Whether it is more at rest.
  bool has_more_at_rest() const { return friction.mu_static.value_or(friction.mu) > friction.mu; }
};

/// The frictions of the mechanism, in their order; then both gears of each mesh that loses power
/// and whose gears turn on its carrier.
std::vector<Rubbing> find_rubbing(const Mechanism& mechanism);

/// Whether hinges on its axis join each gear of a mesh with the carrier.
bool turns_on_carrier(const Mechanism& mechanism, const LossyMesh& mesh);

}  // namespace kinestat
