// What a command line says about a motion, written into the description.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"

namespace kinestat {

/// What the command line says, before what the file says.
struct MotionChoice {
  std::optional<std::string> drive;
  std::optional<std::string> from;   ///< as typed, in the units of the file
  std::optional<std::string> to;     ///< likewise
  std::optional<std::string> steps;  ///< likewise
  std::optional<std::string> label;  ///< of the case
  std::vector<std::string> report;   ///< replaces the list of the file, unless it is empty
};

/// Replaces what the section `motion` says, or makes the section. A value that is no expression, or
/// a drive without an end, is an error, E0101. False iff an error was added.
bool apply(const MotionChoice& choice, MechanismDescription& description, Diagnostics& found);

}  // namespace kinestat
