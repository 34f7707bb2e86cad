// What reports say of a motion with inertia as a whole.
#pragma once

#include <string>

#include "record/record.hpp"
#include "studies/motion/report/motion_dynamics.hpp"

namespace kinestat {

/// Of mass times distance, which is no kind of quantity, from kg*m.
double mass_radius_from_si(double value, const FileUnits& units);
std::string mass_radius_unit(const FileUnits& units);

const Record<MotionDynamics>& motion_dynamics_record();

}  // namespace kinestat
