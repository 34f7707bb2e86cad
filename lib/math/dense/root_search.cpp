#include "math/dense/root_search.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/contract.hpp"

namespace kinestat {

double root_between(const std::function<double(double)>& function, double low, double high) {
  const double at_low = function(low);
  const double at_high = function(high);
  if (at_low == 0.0 || at_high == 0.0) {
    return at_low == 0.0 ? low : high;
  }
  KINESTAT_EXPECTS(low < high && std::signbit(at_low) != std::signbit(at_high));
  // A value that is not finite ends the search there.
  const auto finite = [&](double x) {
    const double value = function(x);
    return std::isfinite(value) ? value : 0.0;
  };
  std::uintmax_t trials = 100;
  const auto [from, to] = boost::math::tools::toms748_solve(
      finite,
      low,
      high,
      at_low,
      at_high,
      boost::math::tools::eps_tolerance<double>(std::numeric_limits<double>::digits - 3),
      trials);
  return from + (to - from) / 2;
}

}  // namespace kinestat
