// The weights of bodies as loads.
#pragma once

#include <vector>

#include "mechanism/cases/load.hpp"
#include "mechanism/check/section_context.hpp"

namespace kinestat {

/// One load gravity.BODY for every body with a mass, at its centre of mass: mass · gravity, about
/// the origin of the evaluator. None without gravity, though masses and centres are evaluated.
/// Bodies without a mass are massless. A mass without a centre is an error, gravity without any
/// mass a warning.
std::vector<Load> bind_weights(const SectionContext& context);

}  // namespace kinestat
