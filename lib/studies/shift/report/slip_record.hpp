// Records of changes whose slip is followed.
#pragma once

#include "cases/analysis.hpp"
#include "record/record.hpp"

namespace kinestat {

struct SlipView {
  const Analysis& analysis;
  const ShiftSlip& slip;
};

const Record<SlipView>& slip_record();
const Record<SlipObstacle>& slip_obstacle_record();

}  // namespace kinestat
