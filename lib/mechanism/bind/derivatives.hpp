// The numbers of a mechanism with their derivatives towards parameters.
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

/// Lists are parallel to those of a Case.
struct CaseDerivatives {
  std::vector<Dual> motions;          ///< of the primary motions
  std::vector<Dual> actions;          ///< of the primary actions
  std::vector<WrenchOf<Dual>> loads;  ///< about the origin of the geometry
  std::vector<Dual> accelerations;    ///< of each primary motion, where forces of inertia act
};

/// Beside a Mechanism, the same numbers as duals: derivative i is per SI unit of the i-th
/// parameter.
struct MechanismDerivatives {
  std::size_t parameter_count = 0;
  GeometryOf<Dual> geometry;
  Dual length;                        ///< of the geometry; NaN where it has a corner or a jump
  std::vector<bool> breaks_coupling;  ///< of each parameter: when it moves, reciprocity is lost or
                                      ///< a number that must be whole, as teeth, is so no longer
  std::vector<CouplingFrictionOf<Dual>> frictions;
  std::vector<bool> starts_friction;           ///< of each parameter: where there is none as yet
  std::vector<Dual> compliances;               ///< of each action
  std::vector<MassNumbersOf<Dual>> masses;     ///< of each body
  std::vector<SpringNumbersOf<Dual>> springs;  ///< of each spring; a force of curves is zero
  std::vector<CaseDerivatives> cases;
};

/// Reads the description again with the parameters of those indices as variables; `mechanism` must
/// be what bind made of it. Another parameter that uses one of them moves with it, as with --set.
MechanismDerivatives bind_derivatives(const MechanismDescription& description,
                                      const Mechanism& mechanism,
                                      std::span<const int> parameters);

}  // namespace kinestat
