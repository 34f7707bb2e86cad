// Arithmetic on fractions times powers of pi; empty where no exact value is known.
#pragma once

#include <optional>

#include "expression/exact.hpp"
#include "expression/functions.hpp"
#include "expression/units.hpp"

namespace kinestat {

using MaybeExact = std::optional<PiRational>;

/// The value, with zero written in one way only; empty if it is beyond the limits of size.
MaybeExact limited(PiRational value);

PiRational negated(const PiRational& a);
MaybeExact add(const PiRational& a, const PiRational& b);
MaybeExact subtract(const PiRational& a, const PiRational& b);
MaybeExact multiply(const PiRational& a, const PiRational& b);
MaybeExact divide(const PiRational& a, const PiRational& b);
MaybeExact raise(const PiRational& base, const PiRational& exponent);

/// A function of two values uses both, one of a single value ignores `b`.
MaybeExact apply(Function function, const PiRational& a, const PiRational& b);

/// The size of a unit in SI.
PiRational size_of(const UnitScale& unit);

/// -1, 0 or 1, as a is smaller than, equal to or larger than b. Empty where that depends on the
/// digits of pi.
std::optional<int> compare(const PiRational& a, const PiRational& b);

}  // namespace kinestat
