// What springs do with the power that they take.
#pragma once

#include <span>
#include <vector>

#include "dynamics/spring_force.hpp"

namespace kinestat {

/// What the damping of a spring dissipates in a state [W]; negative where a spring that acts one
/// way alone gives back what its stiffness took beyond its free length.
double damping_loss(const Spring& spring, const SpringState& state);

/// Of one spring [W].
struct SpringPower {
  double given = 0.0;          ///< by its stiffness, gas and additional force, to the bodies
  double lost = 0.0;           ///< by its damping
  std::size_t first = 0;       ///< index of its first load
  std::size_t load_count = 1;  ///< 2 between moving bodies
};

/// Of all springs of a case; `powers` are those of `loads`, which have the spring_loads of the
/// mechanism. Empty where they have none.
std::vector<SpringPower> spring_powers(const Mechanism& mechanism,
                                       const std::vector<SpringState>& states,
                                       const std::vector<Load>& loads,
                                       std::span<const double> powers);

}  // namespace kinestat
