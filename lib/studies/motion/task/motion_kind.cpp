#include "studies/motion/task/motion_kind.hpp"

namespace kinestat {

std::string unit_text(const FileUnits& units, MotionKind kind) {
  switch (kind) {
    case MotionKind::angle:
      return units.text(QuantityKind::angle);
    case MotionKind::length:
      return units.text(QuantityKind::length);
    case MotionKind::angular_velocity:
      return units.text(QuantityKind::angular_velocity);
    case MotionKind::velocity:
      return units.text(QuantityKind::velocity);
    case MotionKind::angular_acceleration:
      return "rad/s^2";
    case MotionKind::acceleration:
      return units.text(QuantityKind::acceleration);
    case MotionKind::moment:
      return units.text(QuantityKind::moment);
    case MotionKind::force:
      return units.text(QuantityKind::force);
    case MotionKind::power:
      return units.text(QuantityKind::power);
    case MotionKind::number:
      return "";
  }
  return "";
}

double in_file_unit(const FileUnits& units, MotionKind kind, double value) {
  switch (kind) {
    case MotionKind::angle:
      return units.from_si(QuantityKind::angle, value);
    case MotionKind::length:
      return units.from_si(QuantityKind::length, value);
    case MotionKind::angular_velocity:
      return units.from_si(QuantityKind::angular_velocity, value);
    case MotionKind::velocity:
      return units.from_si(QuantityKind::velocity, value);
    case MotionKind::acceleration:
      return units.from_si(QuantityKind::acceleration, value);
    case MotionKind::moment:
      return units.from_si(QuantityKind::moment, value);
    case MotionKind::force:
      return units.from_si(QuantityKind::force, value);
    case MotionKind::power:
      return units.from_si(QuantityKind::power, value);
    case MotionKind::angular_acceleration:
    case MotionKind::number:
      return value;
  }
  return value;
}

}  // namespace kinestat
