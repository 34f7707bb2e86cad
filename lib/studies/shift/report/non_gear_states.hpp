// Which of the combinations that are no gear a shift table shows.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cases/analysis.hpp"
#include "studies/shift/report/shift_text.hpp"

namespace kinestat {

/// Indices of the states behind the gears.
std::vector<std::size_t> shown_others(const ShiftSolution& solution,
                                      std::size_t gears,
                                      ShownOthers shown);

/// "and 28 more locked, 3 more neutral, which --format csv lists", a line; empty without any.
std::string rest_of_others_text(const ShiftSolution& solution,
                                std::size_t gears,
                                const std::vector<std::size_t>& shown);

}  // namespace kinestat
