// What reports say of what couplings bear, and of what acts on them.
#pragma once

#include "mechanism/cables/cable_contact.hpp"
#include "record/record.hpp"
#include "statics/cable_contact_state.hpp"
#include "statics/converter_state.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

struct CouplingWrenchView {
  const Geometry& geometry;
  std::optional<BoundedWrench> wrench;  ///< about the origin of the geometry
  Vec3 at = Vec3::Zero();               ///< point of the coupling [m], in the world
};

const Record<CouplingWrenchView>& coupling_wrench_record();

struct LoadView {
  const Mechanism& mechanism;
  const Load& load;
};

const Record<LoadView>& load_record();

struct FrictionView {
  const Geometry& geometry;
  const FrictionAction& friction;
};

const Record<FrictionView>& friction_record();

/// An action that equal planets share.
struct PlanetShare {
  int count = 0;
  double sharing = 1.0;       ///< load of the most loaded over the mean
  std::optional<double> all;  ///< of all of them together, in SI
  QuantityKind kind = QuantityKind::force;
};

const Record<PlanetShare>& planet_record();

struct ContactView {
  const CableContact& contact;
  const CableContactState& state;
};

const Record<ContactView>& contact_record();

const Record<ConverterState>& converter_record();

}  // namespace kinestat
