// Values of one case in the units of the file, rounding written as zero.
#pragma once

#include "expression/file_units.hpp"
#include "report/zero_snap.hpp"
#include "screw/screw_axis.hpp"

namespace kinestat {

/// Converts from SI; what is below the threshold of its quantity becomes 0.
class InUnits {
 public:
  InUnits(const FileUnits& units, const ZeroSnap& zero) : units_(units), zero_(zero) {}

  double angular(double v) const { return of(QuantityKind::angular_velocity, v, zero_.angular); }

  double linear(double v) const { return of(QuantityKind::velocity, v, zero_.linear); }

  double moment(double v) const { return of(QuantityKind::moment, v, zero_.moment); }

  double force(double v) const { return of(QuantityKind::force, v, zero_.force); }

  double power(double v) const { return of(QuantityKind::power, v, zero_.power); }

  double angle(double v) const { return of(QuantityKind::angle, v, 0.0); }

  double length(double v) const { return of(QuantityKind::length, v, 0.0); }

  /// Of a freedom. The solver has already made zeros of what is rounding, so nothing else is.
  double rate(double v, bool is_rotation) const {
    return of(is_rotation ? QuantityKind::angular_velocity : QuantityKind::velocity, v, 0.0);
  }

  /// Of an action; likewise.
  double action(double v, bool is_couple) const {
    return of(is_couple ? QuantityKind::moment : QuantityKind::force, v, 0.0);
  }

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

  /// In SI, with the components that are rounding set to zero: so that a body at rest has no axis.
  Twist snapped(const Twist& t) const {
    return {.angular = t.angular.unaryExpr([this](double x) { return snap(x, zero_.angular); }),
            .linear = t.linear.unaryExpr([this](double x) { return snap(x, zero_.linear); })};
  }

  Wrench snapped(const Wrench& w) const {
    return {.moment = w.moment.unaryExpr([this](double x) { return snap(x, zero_.moment); }),
            .force = w.force.unaryExpr([this](double x) { return snap(x, zero_.force); })};
  }

  const FileUnits& units() const { return units_; }

 private:
  double of(QuantityKind kind, double value, double threshold) const {
    const double snapped = snap(value, threshold);
    return snapped == 0.0 ? 0.0 : units_.from_si(kind, snapped);
  }

  const FileUnits& units_;
  ZeroSnap zero_;
};

}  // namespace kinestat
