// The numbers of a spring, for any type of number.
#pragma once

#include <cmath>
#include <optional>

#include "core/types.hpp"
#include "expression/file_units.hpp"
#include "math/numbers/dual.hpp"
#include "mechanism/bind/bare_damping.hpp"
#include "mechanism/bind/evaluator.hpp"

namespace kinestat {

/// The numbers of a GasSpring.
template <class Scalar>
struct GasNumbersOf {
  Scalar force;
  Scalar length;
  Scalar stroke;
  Scalar hold;
  Scalar exponent;
};

/// The numbers of a Spring; `force` is its value in one position.
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

/// A damping in SI; a bare number is in the units of the file.
template <class Scalar>
Scalar damping_in_si(const BasicQuantity<Scalar>& typed, bool turns, const FileUnits& units) {
  return is_bare(typed.dimension) ? typed.value * Scalar(bare_damping_unit(units, turns))
                                  : typed.value;
}

/// The free length or position of a spring that has this force, positive if it pushes, at `drawn`.
template <class Scalar>
Scalar free_by_force(const Scalar& drawn, const Scalar& force, const Scalar& stiffness) {
  return drawn + force / stiffness;
}

/// The share of the volume of a gas spring that its whole stroke takes.
template <class Scalar>
Scalar gas_hold(const Scalar& ratio, const Scalar& exponent) {
  using std::pow;
  return Scalar(1.0) - pow(ratio, Scalar(-1.0) / exponent);
}

}  // namespace kinestat
