// Teeth for the stationary ratio of a planetary set.
#pragma once

#include "studies/transmissions/roles.hpp"

namespace kinestat {

/// Numbers of teeth, and how many planets stand round the sun, or pairs of them, which are equal.
struct SetTeeth {
  int sun = 0;
  int planet = 0;
  int ring = 0;
  int planets = 0;

  double stationary_ratio() const { return static_cast<double>(ring) / sun; }
};

/// The smallest set without profile shift of which the planets can be assembled and do not touch,
/// that has the ratio; the smallest within a thousandth where only large ones have it, and the
/// nearest where it is close to 1.
SetTeeth choose_teeth(SetKind kind, double stationary_ratio);

}  // namespace kinestat
