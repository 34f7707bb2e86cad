// Points, lengths and angles of the plane of a synthesis task for people.
#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "report/in_units.hpp"
#include "report/number_format.hpp"
#include "studies/synthesis/positions/plane.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// Values of one task in the units of its file.
class PlaneText {
 public:
  explicit PlaneText(const FileUnits& units) : in_(units) {}

  std::string length(double value) const { return shown(in_.length(value)); }

  std::string angle(double value) const { return shown(in_.angle(value)); }

  std::string point(const Point& p) const {
    return fmt::format("({}, {})", length(p.real()), length(p.imag()));
  }

  /// A dash where there is no number, as of a linkage whose dyads are one.
  static std::string shown(double value) {
    return std::isfinite(value) ? format_short(value) : "-";
  }

  /// The file's unit of angle [rad].
  double unit_of_angle() const { return in_.units().factor(QuantityKind::angle); }

  /// The file's unit of length [m].
  double unit_of_length() const { return in_.units().factor(QuantityKind::length); }

 private:
  InUnits in_;
};

/// The limits with which a linkage would be usable, so that they can be typed as they are printed:
/// " and takes limits: {link_ratio: 12.4}", and how far its pivots are outside their areas; empty
/// where no limit helps, or none is needed.
std::string limits_text(const LinkageCandidate& candidate, const PlaneText& plane);

/// A line on the usable linkages of other kinds than the task asks for; empty without any.
std::string left_out_text(const SynthesisTask& task, const LinkageLimits& limits);

/// What is known of the instant in every position that is prescribed with derivatives: pole,
/// curvature of the path of the origin E, special frame. Empty without such positions.
std::string positions_text(const SynthesisTask& task, const PlaneText& plane);

}  // namespace kinestat
