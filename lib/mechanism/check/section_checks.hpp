// All sections beside bodies, couplings, actuators, cases and loads: their numbers and references.
#pragma once

#include "mechanism/check/section_context.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Evaluates every number of the outlines of bodies, of `losses`, `shift`, `duty`, `motion`,
/// `dynamics`, `simulation`, `sweep` and `synthesis`, resolves every reference, and complains of
/// what is wrong without any analysis. check_gears and check_cables do the same for `gears` and
/// `cables`.
void check_sections(const SectionContext& context);

/// Complains of inputs and outputs of cases that are no actuators, of knowns whose coupling or
/// actuator is not declared, and of couplings of the tree that are not: for a mechanism whose
/// freedoms and actions have no names yet.
void check_case_names(const SectionContext& context);

/// Complains of the freedoms and actions that `motion` and `sweep` report although their couplings
/// do not have them. The topology must hold all couplings, those of gears and cables too.
void check_reported_quantities(const MechanismDescription& description,
                               const Topology& topology,
                               Diagnostics& found);

/// The numbers and references of the section `motion`.
void check_motion(const SectionContext& context);

/// Those of `dynamics`, and that there is a motion.
void check_dynamics(const SectionContext& context);

/// Those of `simulation`; its known motions and actions are bound as those of a case.
void check_simulation(const SectionContext& context);

/// Those of `shift`. Complains of elements and labels that contradict each other, too.
void check_shift(const SectionContext& context);

/// The numbers of `duty` and the actuators that it names; which cases know what is told where they
/// are bound (duty_plan).
void check_duty(const SectionContext& context);

/// Those of `sweep`. Complains of ranges that never end and of sweeps that are too large, too.
void check_sweep(const SectionContext& context);

/// The numbers of `synthesis`. Complains of a task that no linkage can fulfil by its count of
/// positions, too.
void check_synthesis(const SectionContext& context);

/// The numbers of `transmission` of `synthesis`.
void check_transmission(const SectionContext& context, const TransmissionDescription& task);

}  // namespace kinestat
