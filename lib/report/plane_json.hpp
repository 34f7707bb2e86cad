// Points, lengths and angles of the plane of a synthesis task as JSON.
#pragma once

#include <optional>

#include "report/in_units.hpp"
#include "report/json_values.hpp"
#include "synthesis/special_frame.hpp"

namespace kinestat {

/// Values of one task in the units of its file.
class PlaneJson {
 public:
  explicit PlaneJson(const FileUnits& units) : in_(units) {}

  Json length(double value) const { return number(in_.length(value)); }

  Json angle(double value) const { return number(in_.angle(value)); }

  Json point(const Point& p) const { return Json::array({length(p.real()), length(p.imag())}); }

  /// A unit vector.
  static Json direction(const Point& p) {
    return Json::array({number(p.real()), number(p.imag())});
  }

  Json per_length(const std::optional<double>& value) const {
    return value ? number(*value * unit_of_length()) : Json(nullptr);
  }

  Json circle(const Circle& circle) const;

  /// The file's unit of length [m].
  double unit_of_length() const { return in_.units().factor(QuantityKind::length); }

 private:
  InUnits in_;
};

}  // namespace kinestat
