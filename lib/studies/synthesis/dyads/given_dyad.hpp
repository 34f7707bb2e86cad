// Dyads of which the user gives one point, or both.
#pragma once

#include <optional>
#include <span>

#include "studies/synthesis/dyads/dyad.hpp"

namespace kinestat {

struct GivenDyad {
  std::optional<Point> circle_point;  ///< moving frame
  std::optional<Point> centre_point;  ///< fixed frame
  double rounding = 0.0;              ///< by how much each may be off, as it is written [length]
};

enum class GivenFault {
  none,
  open,       ///< the positions leave open what belongs to the given point, or nothing does
  one_alone,  ///< two positions leave a line for the other point
  off_line,   ///< the point is not on that line
  off_curve   ///< four positions have a curve of such points, and the point is not on it
};

struct CompletedDyad {
  std::optional<Dyad> dyad;  ///< without a fault
  GivenFault fault = GivenFault::none;
  DyadPoint which = DyadPoint::circle_point;  ///< the point that is wrong, or lacking

  /// What it may be instead, in its own frame: on a line or curve the nearest. Empty where there is
  /// none.
  std::optional<Point> instead = std::nullopt;
  Point along = {1.0, 0.0};  ///< of a line, in that frame
  double distance = 0.0;     ///< of what is given from that
};

/// The dyad of what is given. Two positions leave a line to a point of a dyad whose other point is
/// given, three nothing, and with four the given point must lie on its curve. What rounding of the
/// given points explains is put right: the dyad has the nearest point of the line or curve.
CompletedDyad complete_dyad(std::span<const PositionJets> positions, const GivenDyad& given);

}  // namespace kinestat
