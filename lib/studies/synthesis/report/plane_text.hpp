// Points, lengths and angles of the plane of a synthesis task for people.
#pragma once

#include <string>

#include <fmt/format.h>

#include "report/in_units.hpp"
#include "report/number_format.hpp"
#include "studies/synthesis/positions/plane.hpp"

namespace kinestat {

/// Values of one task in the units of its file.
class PlaneText {
 public:
  explicit PlaneText(const FileUnits& units) : in_(units) {}

  std::string length(double value) const { return format_short(in_.length(value)); }

  std::string angle(double value) const { return format_short(in_.angle(value)); }

  std::string point(const Point& p) const {
    return fmt::format("({}, {})", length(p.real()), length(p.imag()));
  }

  /// The file's unit of angle [rad].
  double unit_of_angle() const { return in_.units().factor(QuantityKind::angle); }

  /// The file's unit of length [m].
  double unit_of_length() const { return in_.units().factor(QuantityKind::length); }

 private:
  InUnits in_;
};

}  // namespace kinestat
