// The curves of four positions as JSON.
#pragma once

#include <span>

#include "report/plane_json.hpp"
#include "synthesis/few_positions.hpp"

namespace kinestat {

/// The part of the plane in which a curve is drawn, and with how many points.
struct CurveWindow {
  Point middle;
  double radius = 1.0;
  int count = 200;
};

/// Coefficients in the fixed frame, in the file's unit of length. A curve of circle points comes
/// with the positions that it stems from: each of its points has its centre beside it, null where
/// that is at infinity.
Json cubic_json(const PlaneCubic& cubic,
                const CurveWindow& window,
                const PlaneJson& plane,
                std::span<const PositionJets> positions = {});

}  // namespace kinestat
