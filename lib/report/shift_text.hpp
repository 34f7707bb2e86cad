// The states of a transmission as tables for people.
#pragma once

#include <string>

#include "report/analysis.hpp"

namespace kinestat {

/// The truth table, what is no gear and why, torques and slips of the elements, changes of gear.
/// The analysis must have the section `shift`.
std::string shift_text(const Analysis& analysis);

}  // namespace kinestat
