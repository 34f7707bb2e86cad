// What torque converters add to the couplings of a mechanism.
#pragma once

#include <string>

#include "description/mechanism_description.hpp"

namespace kinestat {

/// The coupling by which the stator of a converter reacts on the turbine: "TC_stator".
std::string stator_name(const CouplingDescription& converter);

/// Appends for each torque converter with a stator a second coupling of its type, from the body of
/// the stator to that of the turbine: three bodies need two edges.
///
/// To be done once, after reading and before expand_gears, which places both on their axis.
void expand_converters(MechanismDescription& description);

}  // namespace kinestat
