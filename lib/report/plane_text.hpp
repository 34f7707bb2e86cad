// Points, lengths and angles of the plane of a synthesis task for people.
#pragma once

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "report/in_units.hpp"
#include "report/numbers.hpp"
#include "report/plane_zero.hpp"
#include "synthesis/plane.hpp"

namespace kinestat {

/// Values of one task in the units of its file.
class PlaneText {
 public:
  /// Lengths below `zero` [m] are rounding and written as zero.
  PlaneText(const FileUnits& units, double zero) : in_(units), zero_(zero) {}

  /// The same with lengths below `zero` [m] written as zero, if that is more.
  PlaneText with_zero(double zero) const { return {in_.units(), std::max(zero_, zero)}; }

  std::string length(double value) const { return format_short(in_.length(snap(value, zero_))); }

  /// A difference of places, which may be smaller than the zero of a place.
  std::string difference(double value) const { return format_short(in_.length(value)); }

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
  double zero_ = 0.0;
};

}  // namespace kinestat
