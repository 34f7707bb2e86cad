// A number of the file that may follow curves.
#pragma once

#include <memory>

#include "expression/number_law.hpp"

namespace kinestat {

struct MovingNumber {
  double value = 0.0;                            ///< [SI] of one that does not move
  std::shared_ptr<const NumberLaw<double>> law;  ///< of one that does: of curves
};

}  // namespace kinestat
