// Numbers of a description that pictures need and a Mechanism does not keep.
#pragma once

#include <optional>

#include "couplings/cable_geometry.hpp"
#include "description/mechanism_description.hpp"
#include "expression/parameters.hpp"
#include "screw/local_origin.hpp"

namespace kinestat {

/// Of a description that has been bound without an error, and must outlive it. Answers are in SI,
/// and empty where the file has no such number.
class FileNumbers {
 public:
  explicit FileNumbers(const MechanismDescription& description, const LocalOrigin& origin = {});

  std::optional<double> number(const Value& value, QuantityKind kind) const;

  /// [m], from the origin; z is 0 in the plane.
  std::optional<Vec3> point(const PointDescription& point) const;

  /// A station of a CablePart, whose centre and axis are filled in; its radius is 0 where the file
  /// does not give it.
  std::optional<CableStationGeometry> station(const CableStation& station) const;

 private:
  std::optional<Vec3> direction(const AxisDescription& axis) const;

  const MechanismDescription& description_;
  LocalOrigin origin_;
  ParameterTable table_;
};

}  // namespace kinestat
