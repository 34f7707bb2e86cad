// A number with its first derivatives with respect to chosen variables.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace kinestat {

/// The functions below apply the chain rule. Where the function has a corner (abs at 0, min and max
/// of equal values, hypot at the origin), jumps (a step, atan2 at the origin) or grows without
/// bound (sqrt at 0, asin and acos at ±1, a power of zero with an exponent below one), there is no
/// derivative. It is NaN, and so is all that depends on it. A variable that does not take part
/// keeps its zero, and one that moves both sides of a corner alike keeps its slope.
struct Dual {
  double value = 0.0;
  std::vector<double> derivatives;  ///< one a variable; an empty list stands for zeros

  Dual() = default;

  /// A constant, unless derivatives are given. Not explicit: numbers mix with duals in formulas.
  Dual(double constant, std::vector<double> slopes = {})
      : value(constant), derivatives(std::move(slopes)) {}
};

/// The number without its derivatives, for decisions that do not depend on them.
inline double value_of(const Dual& number) {
  return number.value;
}

inline double value_of(double number) {
  return number;
}

/// The variable of that index among `count`: its own derivative is one.
Dual make_variable(double value, std::size_t index, std::size_t count);

/// The derivative with respect to a variable.
double derivative(const Dual& number, std::size_t variable);

/// The value of a function with the slope `by_a` towards a.
Dual chain(double value, double by_a, const Dual& a);

/// The value of a function with the slopes `by_a` towards a and `by_b` towards b.
Dual chain(double value, double by_a, const Dual& a, double by_b, const Dual& b);

Dual operator-(const Dual& a);
Dual operator+(const Dual& a, const Dual& b);
Dual operator-(const Dual& a, const Dual& b);

/// A factor that is zero and stays so leaves nothing of the other, whether that has a derivative or
/// not.
Dual operator*(const Dual& a, const Dual& b);

Dual operator/(const Dual& a, const Dual& b);

Dual sin(const Dual& a);
Dual cos(const Dual& a);
Dual tan(const Dual& a);
Dual asin(const Dual& a);
Dual acos(const Dual& a);
Dual atan(const Dual& a);

/// The angle of the point (x, y).
Dual atan2(const Dual& y, const Dual& x);

Dual sqrt(const Dual& a);
Dual abs(const Dual& a);
Dual exp(const Dual& a);
Dual log(const Dual& a);
Dual log10(const Dual& a);

/// A derivative towards the exponent exists only for a positive base, or 0 with a positive
/// exponent.
Dual pow(const Dual& base, const Dual& exponent);

/// Of a function that is constant between its jumps: `jumps` says whether it has one here.
Dual staircase(double value, bool jumps, const Dual& a);
Dual staircase(double value, bool jumps, const Dual& a, const Dual& b);

/// Whether rounding alone decides which of two numbers is the larger.
bool is_tie(double a, double b);

Dual min(const Dual& a, const Dual& b);
Dual max(const Dual& a, const Dual& b);
Dual hypot(const Dual& a, const Dual& b);

}  // namespace kinestat
