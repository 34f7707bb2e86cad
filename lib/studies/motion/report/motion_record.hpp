// What reports say of a finite motion.
#pragma once

#include "record/record.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

const Record<MotionTable>& motion_record();

}  // namespace kinestat
