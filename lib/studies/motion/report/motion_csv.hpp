// A finite motion as a tidy table.
#pragma once

#include <string>
#include <string_view>

#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// The header of the table: that of every table, and the position to which a value belongs.
inline constexpr std::string_view kMotionCsvHeader =
    "mechanism,case,pass,element,quantity,value,unit,status,step,drive\n";

/// One line a value of the rows, with the step and the position of the first drive there. Events
/// have their kind as quantity, the step before and their position of the drive, also as value;
/// gaps and corrections of the drawn position have no step.
std::string motion_csv(const std::string& mechanism, const MotionTable& motion);

}  // namespace kinestat
