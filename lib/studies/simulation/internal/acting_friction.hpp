// Dry friction at work in a simulation.
#pragma once

#include <cstddef>

#include "core/types.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

/// A dry friction that slides.
struct ActingFriction {
  std::size_t index = 0;
  FrictionLaw law;
  double rate = 0.0;  ///< against which it works
  VecX work = {};     ///< on unit speeds of all coordinates, by unit of it
  VecX answer = {};   ///< how it speeds up the free ones, likewise
};

}  // namespace kinestat
