// Dry friction at work in a simulation.
#pragma once

#include <cstddef>
#include <vector>

#include "core/types.hpp"
#include "mechanism/cases/load.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

/// A dry friction that slides.
struct ActingFriction {
  std::size_t index = 0;
  FrictionLaw law;
  double rate = 0.0;  ///< against which it works
  VecX work = {};     ///< on unit speeds of all coordinates, by unit of it
  VecX answer = {};   ///< how it speeds up the free ones, likewise
  std::vector<BodyWrench> along =
      {};  ///< forces of inertia and of what holds coordinates, likewise
};

}  // namespace kinestat
