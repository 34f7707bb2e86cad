// Checks of the numbers and references of all sections except bodies, couplings, actuators, cases
// and loads.
#pragma once

#include "mechanism/check/section_context.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Evaluates every number of the outlines of bodies, of `losses`, `shift`, `duty`, `motion`,
/// `dynamics`, `simulation`, `sweep` and `synthesis`, resolves every reference, and adds errors for
/// whatever is wrong without an analysis. check_gears and check_cables do the same for `gears` and
/// `cables`.
void check_sections(const SectionContext& context);

/// Adds an error for each input or output of a case that is no actuator, and for each known
/// magnitude or coupling of the tree that is not declared. For a mechanism whose freedoms and
/// actions have no names yet.
void check_case_names(const SectionContext& context);

/// Adds an error for each freedom or action that `motion` or `sweep` report although its coupling
/// does not have it. The topology must have all couplings, with those of gears and cables.
void check_reported_quantities(const MechanismDescription& description,
                               const Topology& topology,
                               Diagnostics& found);

/// Checks the numbers and references of the section `motion`.
void check_motion(const SectionContext& context);

/// Checks those of `dynamics`, and that the file has a motion.
void check_dynamics(const SectionContext& context);

/// Checks those of `simulation`. Its known motions and actions are bound as those of a case.
void check_simulation(const SectionContext& context);

/// Checks those of `shift`, and that elements and labels do not contradict each other.
void check_shift(const SectionContext& context);

/// Checks the numbers of `duty` and the actuators that it names. Whether the cases know these
/// magnitudes is checked when the section is bound (duty_plan).
void check_duty(const SectionContext& context);

/// Checks the numbers and references of `sweep`, and that its ranges end and it is not too large.
void check_sweep(const SectionContext& context);

/// Checks the numbers of `synthesis`, and that a dyad can meet its number of positions.
void check_synthesis(const SectionContext& context);

/// Checks the numbers of `transmission` in `synthesis`.
void check_transmission(const SectionContext& context, const TransmissionDescription& task);

}  // namespace kinestat
