// The numbers of a mechanism with their derivatives with respect to parameters.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "description/mechanism_description.hpp"
#include "math/numbers/dual_vector.hpp"
#include "mechanism/inertia/mass_numbers.hpp"
#include "mechanism/mechanism.hpp"
#include "mechanism/springs/spring_numbers.hpp"

namespace kinestat {

/// The numbers of a case as duals. Lists are parallel to those of the Case.
struct CaseDerivatives {
  std::vector<Dual> motions;          ///< of the primary motions
  std::vector<Dual> actions;          ///< of the primary actions
  std::vector<WrenchOf<Dual>> loads;  ///< about the origin of the geometry
  std::vector<Dual> accelerations;    ///< of each primary motion, if inertia forces act
};

/// The numbers of a Mechanism as duals: derivative i is per SI unit of the i-th parameter.
struct MechanismDerivatives {
  std::size_t parameter_count = 0;
  GeometryOf<Dual> geometry;
  Dual length;                        ///< size of the geometry; its derivatives are NaN at a corner
  std::vector<bool> breaks_coupling;  ///< of each parameter: a change makes a coupling lose its
                                      ///< reciprocity, or a number of teeth cease to be whole
  std::vector<CouplingFrictionOf<Dual>> frictions;
  std::vector<bool> starts_friction;           ///< of each parameter: a change starts a friction
  std::vector<Dual> compliances;               ///< of each action
  std::vector<MassNumbersOf<Dual>> masses;     ///< of each body
  std::vector<SpringNumbersOf<Dual>> springs;  ///< of each spring; a force by curves is zero here
  std::vector<CaseDerivatives> cases;
};

/// Binds the description again with the parameters of these indices as variables. `mechanism` must
/// be what bind made of it. Parameters that depend on a variable change with it, as with --set.
MechanismDerivatives bind_derivatives(const MechanismDescription& description,
                                      const Mechanism& mechanism,
                                      std::span<const int> parameters);

}  // namespace kinestat
