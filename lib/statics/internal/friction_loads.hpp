// What acts in a case with friction.
#pragma once

#include <span>

#include "mechanism/cases/load.hpp"
#include "mechanism/mechanism.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

struct FrictionLoads {
  std::span<const Primary> primaries;
  std::span<const BodyWrench> loads;
  std::span<const FrictionLaw> laws;
};

}  // namespace kinestat
