// A number of the file that may follow curves.
#pragma once

#include <memory>

#include "expression/number_law.hpp"

namespace kinestat {

struct MovingNumber {
  double value = 0.0;                            ///< [SI], if the number does not follow curves
  std::shared_ptr<const NumberLaw<double>> law;  ///< as a function of curves, if it does; else null
};

}  // namespace kinestat
