#include "description/number_range.hpp"

#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

bool NumberRange::holds(double value) const {
  const auto is_whole_up_to_rounding = [value] {
    return std::abs(value - std::round(value)) <= kCancellation * std::abs(value);
  };
  return (!least || value >= *least) && (!most || value <= *most) && (!above || value > *above) &&
         (!below || value < *below) && (!is_not_zero || value != 0.0) &&
         (!is_whole || is_whole_up_to_rounding());
}

NumberRange in_any_unit(const NumberRange& range) {
  NumberRange result = range;
  for (auto bound :
       {&NumberRange::least, &NumberRange::most, &NumberRange::above, &NumberRange::below}) {
    if (result.*bound && *(result.*bound) != 0.0) {
      (result.*bound).reset();
    }
  }
  return result;
}

}  // namespace kinestat
