// How the drawn position of a motion was closed, in the units of the file.
#pragma once

#include "expression/file_units.hpp"
#include "mechanism/mechanism.hpp"
#include "studies/motion/motion_solution.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// What its couplings miss, as drawn and at the nearest position, and how far bodies were moved.
void add_assembly(const Assembly& assembly,
                  const Mechanism& mechanism,
                  const FileUnits& units,
                  MotionTable& table);

}  // namespace kinestat
