// The loads of cases, bound to numbers.
#pragma once

#include <span>
#include <vector>

#include "mechanism/cases/case.hpp"
#include "mechanism/cases/load.hpp"
#include "mechanism/check/section_context.hpp"
#include "mechanism/inertia/mass_binder.hpp"

namespace kinestat {

/// The loads of a case: those of the top level, each replaced by a load of the case with the same
/// name, then the other loads of the case, then the weights. Places and wrenches refer to the
/// origin of the evaluator.
struct CaseLoads {
  std::vector<Load> loads;
  std::vector<MovingLoad> moving;  ///< the loads that follow curves
};

/// Binds the loads of each case, in the order of the cases, and adds errors. A load on the ground,
/// which does nothing, is left out with a warning.
std::vector<CaseLoads> bind_loads(const SectionContext& context,
                                  const std::vector<DescribedMass>& masses,
                                  std::span<const Curve> curves);

/// Adds the loads to the cases. A case with loads is solved for its actions.
void add_loads(std::vector<CaseLoads> loads, std::vector<Case>& cases);

/// Whether a name is that of a load of the file or of the case, or of the weight of a body, even if
/// this body has no mass.
bool names_load(const Name& name, const CaseDescription& one, const SectionContext& context);

/// Finds the loads, weights included, that cases name as inputs or outputs. Adds an error for each
/// that does not act in its case.
void bind_load_ends(const SectionContext& context, std::vector<Case>& cases);

/// Makes one load gravity.BODY, mass times gravity at the centre of mass, for every body with a
/// mass; none without gravity. Wrenches are about the origin of the evaluator. `masses` are those
/// of the bodies of the description. A mass without a centre is an error, except that of a gear,
/// which place_gear_weights puts in its place. Gravity without any mass is a warning.
std::vector<Load> bind_weights(const SectionContext& context,
                               const std::vector<DescribedMass>& masses);

/// Puts the weights of gears without a centre on their axes. The weights of equal planets at equal
/// angles around a carrier are replaced by their sum, which acts on the carrier at its axis; if the
/// carrier is the ground, they are left out. `masses` are those of the bodies of the topology.
void place_gear_weights(const SectionContext& context,
                        const std::vector<BodyMass>& masses,
                        std::vector<CaseLoads>& cases);

}  // namespace kinestat
