// A position of a synthesis task as JSON.
#pragma once

#include "report/plane_json.hpp"
#include "synthesis/position_jets.hpp"

namespace kinestat {

/// The pose with its derivatives, the pole, the curvature of the path of the origin of the moving
/// frame, and the special frame of the instant, as far as the order of the position goes.
Json position_json(const PositionJets& position, const PlaneJson& plane);

}  // namespace kinestat
