// The loads of cases in numbers.
#pragma once

#include <span>
#include <vector>

#include "mechanism/cases/case.hpp"
#include "mechanism/cases/load.hpp"
#include "mechanism/check/section_context.hpp"
#include "mechanism/inertia/mass_binder.hpp"

namespace kinestat {

/// What acts in a case: the loads of the top level, each replaced by the case's own of its name,
/// then the other ones of the case, then the weights. Places and wrenches are from the origin of
/// the evaluator.
struct CaseLoads {
  std::vector<Load> loads;
  std::vector<MovingLoad> moving;  ///< those that follow curves
};

/// Of each case, in their order. Evaluates every load and complains; one on the ground, which does
/// nothing, is left out with a warning.
std::vector<CaseLoads> bind_loads(const SectionContext& context,
                                  const std::vector<DescribedMass>& masses,
                                  std::span<const Curve> curves);

/// Gives the cases their loads; one on which any acts asks for its actions.
void add_loads(std::vector<CaseLoads> loads, std::vector<Case>& cases);

/// Whether a name is that of a load of the file, of a load of the case, or of the weight of a body,
/// be there one or not.
bool names_load(const Name& name, const CaseDescription& one, const SectionContext& context);

/// Finds the loads that cases name as input or output among those that act in them, the weights
/// included; complains of those that do not.
void bind_load_ends(const SectionContext& context, std::vector<Case>& cases);

/// One load gravity.BODY for every body with a mass, at its centre of mass: mass · gravity, about
/// the origin of the evaluator. None without gravity; `masses` are those of the description's
/// bodies. Bodies without a mass are massless. A mass without a centre is an error unless it is
/// that of a gear, which place_gear_weights puts in its place; gravity without any mass is a
/// warning.
std::vector<Load> bind_weights(const SectionContext& context,
                               const std::vector<DescribedMass>& masses);

/// Gives the weights of gears without a centre their place on the axis, and those of equal planets,
/// which turn about their carrier at equal angles, to that carrier: the sum of all of them, on its
/// axis. Those that the ground carries are left out. `masses` are those of the bodies of the
/// topology.
void place_gear_weights(const SectionContext& context,
                        const std::vector<BodyMass>& masses,
                        std::vector<CaseLoads>& cases);

}  // namespace kinestat
