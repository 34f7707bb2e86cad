// What the evaluators of random expressions share: values with slopes and bounds of rounding.
#pragma once

#include <string>

#include "property/expression_sample.hpp"

namespace kinestat::sample {

inline constexpr long double kRounding = 4 * 2.22e-16L;  ///< of one operation with doubles
inline constexpr long double kLoose = 1e-6L;  ///< relative errors above this bend formulas

bool is_bare(const Powers& powers);

bool is_integer(long double value);

Meaning fault(Verdict verdict);

/// Whether rounding may turn the value into `level` or past it.
bool is_near(const Meaning& a, long double level);

/// Whether the value is too uncertain for a function that is singular at zero.
bool is_loose(const Meaning& a);

Meaning constant(long double value, const Powers& powers);

/// f(a, b) by its value and its slopes towards both, with the dimension of a.
Meaning chain(
    long double value, long double by_a, const Meaning& a, long double by_b, const Meaning& b);

Meaning chain(long double value, long double by_a, const Meaning& a);

Meaning with_powers(Meaning a, const Powers& powers);

Meaning not_smooth_if(bool is_kink, Meaning a);

/// A call of one or two values; `b` is `a` where there is one.
Meaning called(const Tree& tree, const Meaning& a, const Meaning& b);

}  // namespace kinestat::sample
