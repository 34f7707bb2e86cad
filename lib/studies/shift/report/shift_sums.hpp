// What speeds and torques are made of those of the inputs, as text.
#pragma once

#include <string>
#include <vector>

#include "cases/analysis.hpp"
#include "cases/report/ratio_in_units.hpp"

namespace kinestat {

/// "out = 0.333333 engine + 0.666667 motor": of an actuator, with a share for each input.
std::string sum_text(const Analysis& analysis,
                     int actuator,
                     const std::vector<RatioInUnits>& shares);

/// "out = -0.722222 engine - 2.63636 MG2, MG1 = -0.277778 engine": the torques of outputs and of
/// what reacts; empty where none are known so.
std::string torque_sums(const Analysis& analysis, const ShiftState& state);

}  // namespace kinestat
