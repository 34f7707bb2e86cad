// The numbers of a spring for any type of number.
#pragma once

#include <cmath>
#include <optional>

#include "core/types.hpp"
#include "expression/file_units.hpp"
#include "math/numbers/dual.hpp"
#include "mechanism/bind/bare_damping.hpp"
#include "mechanism/bind/evaluator.hpp"

namespace kinestat {

/// As GasSpring has them.
template <class Scalar>
struct GasNumbersOf {
  Scalar force;
  Scalar length;
  Scalar stroke;
  Scalar hold;
  Scalar exponent;
};

/// As Spring has them; `force` is what it is in a position.
template <class Scalar>
struct SpringNumbersOf {
  Vec3Of<Scalar> from = Vec3Of<Scalar>::Zero();
  Vec3Of<Scalar> to = Vec3Of<Scalar>::Zero();
  Scalar stiffness = Scalar(0.0);
  Scalar damping = Scalar(0.0);
  Scalar free = Scalar(0.0);
  Scalar force = Scalar(0.0);
  std::optional<GasNumbersOf<Scalar>> gas = {};
};

/// A damping as typed in SI: a bare number counts in the units of the file.
template <class Scalar>
Scalar damping_in_si(const BasicQuantity<Scalar>& typed, bool turns, const FileUnits& units) {
  return is_bare(typed.dimension) ? typed.value * Scalar(bare_damping_unit(units, turns))
                                  : typed.value;
}

/// Where a spring has no force that has this one, pushing positive, at `drawn`.
template <class Scalar>
Scalar free_by_force(const Scalar& drawn, const Scalar& force, const Scalar& stiffness) {
  return drawn + force / stiffness;
}

/// What the whole stroke takes of the volume of a gas spring.
template <class Scalar>
Scalar gas_hold(const Scalar& ratio, const Scalar& exponent) {
  using std::pow;
  return Scalar(1.0) - pow(ratio, Scalar(-1.0) / exponent);
}

}  // namespace kinestat
