// The equations of both sides of a case.
#pragma once

#include "mechanism/mechanism.hpp"
#include "studies/sensitivity/internal/factored_side.hpp"

namespace kinestat {

FactoredSide motion_equations(const Mechanism& mechanism,
                              const Case& which,
                              const CoordinateBasis& basis);

FactoredSide action_equations(const Mechanism& mechanism,
                              const Case& which,
                              const CoordinateBasis& basis);

}  // namespace kinestat
