// Kinds of values of a finite motion, and their units.
#pragma once

#include <string>

#include "expression/file_units.hpp"

namespace kinestat {

/// Values of one kind, in SI.
enum class MotionKind {
  angle,
  length,
  angular_velocity,
  velocity,
  angular_acceleration,
  acceleration,
  moment,
  force,
  power,
  number
};

/// A value of that kind in the unit of the file, and the unit.
double in_file_unit(const FileUnits& units, MotionKind kind, double value);
std::string unit_text(const FileUnits& units, MotionKind kind);

}  // namespace kinestat
