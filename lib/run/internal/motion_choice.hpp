// What a command line says about a motion, written into the description.
#pragma once

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "run/motion.hpp"

namespace kinestat {

/// Replaces what the section `motion` says, or makes the section. A value that is no expression, or
/// a drive without an end, is an error, E0101. False iff an error was added.
bool apply(const MotionChoice& choice, MechanismDescription& description, Diagnostics& found);

}  // namespace kinestat
