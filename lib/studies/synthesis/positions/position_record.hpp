// What reports say of a position of the plane.
#pragma once

#include "expression/file_units.hpp"
#include "record/record.hpp"
#include "studies/synthesis/positions/position_jets.hpp"

namespace kinestat {

struct PositionView {
  const PositionJets& position;
  const FileUnits& units;  ///< of curvatures
};

/// The pose with its derivatives, the pole, the curvature of the path of the origin of the moving
/// frame, and the special frame of the instant, as far as the order of the position goes.
const Record<PositionView>& position_record();

}  // namespace kinestat
