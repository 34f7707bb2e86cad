// The sections of a mechanism file, each declared once.
#pragma once

#include <vector>

#include "description/mechanism_description.hpp"
#include "forms/mapping.hpp"

namespace kinestat {

const Mapping<FileUnits>& units_section();
Form<std::vector<ParameterDescription>> parameters();
Form<std::vector<BodyDescription>> bodies();
Form<std::vector<CouplingDescription>> couplings();
const Mapping<GearsDescription>& gears_section();
Form<std::vector<CableDescription>> cables();
Form<std::vector<ActuatorDescription>> actuators();
Form<std::vector<LoadDescription>> loads();
Form<std::vector<SpringDescription>> springs();
Form<std::vector<CurveDescription>> curves();
Form<std::vector<CaseDescription>> cases();
const Mapping<LossDescription>& losses_section();
const Mapping<ShiftDescription>& shift_section();
const Mapping<DutyDescription>& duty_section();
const Mapping<MotionDescription>& motion_section();
const Mapping<DynamicsDescription>& dynamics_section();
const Mapping<SimulationDescription>& simulation_section();
const Mapping<SweepDescription>& sweep_section();
Form<std::vector<PublishedValue>> published();
const Mapping<SynthesisDescription>& synthesis_section();

/// The sections as the keys of the file.
const Mapping<MechanismDescription>& file_sections();

/// The file as a value to be read. Its space is known beforehand, since all points need it.
FileValue whole_file(const YamlNode& root, Diagnostics& found);

}  // namespace kinestat
