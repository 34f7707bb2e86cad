// The loads of cases in numbers.
#pragma once

#include <vector>

#include "mechanism/cases/case.hpp"
#include "mechanism/check/section_context.hpp"

namespace kinestat {

/// What acts in each case, in the order of the cases: the loads of the top level, each replaced by
/// the case's own of its name, then the other ones of the case, then the weights. Places and
/// wrenches are from the origin of the evaluator. Evaluates every load and complains; one on the
/// ground, which does nothing, is left out with a warning.
std::vector<std::vector<Load>> bind_loads(const SectionContext& context);

/// Gives the cases their loads; one on which any acts asks for its actions.
void add_loads(std::vector<std::vector<Load>> loads, std::vector<Case>& cases);

}  // namespace kinestat
