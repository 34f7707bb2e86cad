// What acts along a motion, as the script draws it.
#pragma once

#include <string>

#include "cases/analysis.hpp"
#include "draw/linkage/drawn_actions.hpp"

namespace kinestat {

/// `"acting"`: of each arrow its name, group, unit and, at each step, the components of its vector
/// in the unit of the file, then of its place [m] unless `"place"` is that of all steps; null where
/// it is not known. `"doubts"`: their words, then of each step one more than the index of its own,
/// or 0. Empty where nothing acts.
std::string acting_json(const DrawnActions& acting, const Analysis& analysis);

}  // namespace kinestat
