// What a number measures, in a word or a few.
#pragma once

#include <string>

#include "record/shape.hpp"

namespace kinestat {

/// "angular velocity", "count", "in the unit beside it".
std::string word_of(const Measure& measure);

}  // namespace kinestat
