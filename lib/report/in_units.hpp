// Values in the units of the file.
#pragma once

#include "expression/file_units.hpp"
#include "mechanism/label_kind.hpp"
#include "screw/screw_axis.hpp"

namespace kinestat {

/// Converts from SI. What is zero has been made so where it was computed; -0 is written as 0.
class InUnits {
 public:
  explicit InUnits(const FileUnits& units) : units_(units) {}

  double angular(double v) const { return of(QuantityKind::angular_velocity, v); }

  double linear(double v) const { return of(QuantityKind::velocity, v); }

  double moment(double v) const { return of(QuantityKind::moment, v); }

  double force(double v) const { return of(QuantityKind::force, v); }

  double power(double v) const { return of(QuantityKind::power, v); }

  double angle(double v) const { return of(QuantityKind::angle, v); }

  double length(double v) const { return of(QuantityKind::length, v); }

  /// Of a freedom.
  double rate(double v, bool is_rotation) const { return of(rate_kind(is_rotation), v); }

  /// Of an action.
  double action(double v, bool is_couple) const { return of(action_kind(is_couple), v); }

  Vec3 angular(const Vec3& v) const {
    return v.unaryExpr([this](double x) { return angular(x); });
  }

  Vec3 linear(const Vec3& v) const {
    return v.unaryExpr([this](double x) { return linear(x); });
  }

  Vec3 moment(const Vec3& v) const {
    return v.unaryExpr([this](double x) { return moment(x); });
  }

  Vec3 force(const Vec3& v) const {
    return v.unaryExpr([this](double x) { return force(x); });
  }

  Vec3 length(const Vec3& v) const {
    return v.unaryExpr([this](double x) { return length(x); });
  }

  const FileUnits& units() const { return units_; }

  double of(QuantityKind kind, double value) const {
    return value == 0.0 ? 0.0 : units_.from_si(kind, value);
  }

 private:
  const FileUnits& units_;
};

}  // namespace kinestat
