// Where a function of one argument is zero.
#pragma once

#include <functional>

namespace kinestat {

/// The place between `low` and `high`, where the values of a continuous function have opposite
/// signs or one is zero, at which it is zero, to the last digits; where it is not finite on the
/// way, the best place that was found.
double root_between(const std::function<double(double)>& function, double low, double high);

}  // namespace kinestat
