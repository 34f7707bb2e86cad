// Points, lengths and angles of the plane of a synthesis task as JSON.
#pragma once

#include <algorithm>
#include <optional>

#include "core/tolerance.hpp"
#include "report/in_units.hpp"
#include "report/json_values.hpp"
#include "report/plane_zero.hpp"
#include "synthesis/special_frame.hpp"

namespace kinestat {

/// Values of one task in the units of its file.
class PlaneJson {
 public:
  /// Lengths below `zero` [m] are rounding and written as zero.
  PlaneJson(const FileUnits& units, double zero) : in_(units), zero_(zero) {}

  /// The same with lengths below `zero` [m] written as zero, if that is more.
  PlaneJson with_zero(double zero) const { return {in_.units(), std::max(zero_, zero)}; }

  Json length(double value) const { return number(in_.length(snap(value, zero_))); }

  /// A difference of places, which may be smaller than the zero of a place.
  Json difference(double value) const { return number(in_.length(value)); }

  Json angle(double value) const { return number(in_.angle(value)); }

  Json point(const Point& p) const { return Json::array({length(p.real()), length(p.imag())}); }

  /// A unit vector.
  static Json direction(const Point& p) {
    return Json::array(
        {number(snap(p.real(), kReportsAgreeInZero)), number(snap(p.imag(), kReportsAgreeInZero))});
  }

  Json per_length(const std::optional<double>& value) const {
    return value ? number(*value * unit_of_length()) : Json(nullptr);
  }

  Json circle(const Circle& circle) const;

  /// The file's unit of length [m].
  double unit_of_length() const { return in_.units().factor(QuantityKind::length); }

 private:
  InUnits in_;
  double zero_ = 0.0;
};

}  // namespace kinestat
