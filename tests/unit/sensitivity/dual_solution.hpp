// A case solved in dual numbers by dense Gauss elimination: an independent way to derivatives.
#pragma once

#include <vector>

#include "mechanism/bind/derivatives.hpp"

namespace kinestat {

/// The rates of all freedoms in the first case, with their derivatives towards the parameters.
std::vector<Dual> dual_rates(const Mechanism& mechanism, const MechanismDerivatives& derivatives);

/// The magnitudes of all actions likewise; the case must determine them.
std::vector<Dual> dual_actions(const Mechanism& mechanism, const MechanismDerivatives& derivatives);

}  // namespace kinestat
