// Real roots of a polynomial of low degree.
#pragma once

#include <vector>

namespace kinestat {

/// The value at x of c_0 + c_1 x + c_2 x² + …
double polynomial_value(const std::vector<double>& coefficients, double x);

/// Where the polynomial changes its sign between low and high, rising. Between two neighbouring
/// extremes, the roots of the derivative, there is at most one such place, found by bisection to
/// the last bit; a root that only touches zero is none.
std::vector<double> find_sign_changes(const std::vector<double>& coefficients,
                                      double low,
                                      double high);

}  // namespace kinestat
