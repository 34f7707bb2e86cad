// A number with its dimension, and the dimensions that the places of a mechanism file expect.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace kinestat {

/// Exponents of the base quantities. The angle is one of them, so that degrees, radians and bare
/// numbers do not mix unnoticed.
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  int angle = 0;

  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// The dimension of a product.
Dimension operator*(const Dimension& a, const Dimension& b);

/// The dimension of a quotient.
Dimension operator/(const Dimension& a, const Dimension& b);

/// The dimension of a whole power.
Dimension power(const Dimension& base, int exponent);

/// True for a bare number: all exponents are zero.
bool is_bare(const Dimension& dimension);

/// A value in SI: metre, kilogram, second, radian. `Number` is double, Dual (math/numbers/dual.hpp:
/// with derivatives), Exact (exact.hpp: with its exact value where it has one) or
/// ExactInput (math/numbers/exact_input.hpp: likewise, and with a hundred digits).
template <class Number>
struct BasicQuantity {
  Number value{};
  Dimension dimension;
};

using Quantity = BasicQuantity<double>;

/// What a place of a mechanism file expects. `pitch` is a length per radian, `lead` a length per
/// turn; `inertia` is a mass times a length squared; `stiffness` resists a translation,
/// `angular_stiffness` a rotation.
enum class QuantityKind {
  dimensionless,
  length,
  angle,
  time,
  mass,
  inertia,
  force,
  moment,
  velocity,
  angular_velocity,
  acceleration,
  angular_acceleration,
  power,
  energy,
  stiffness,
  angular_stiffness,
  pitch,
  lead
};

inline constexpr std::size_t kQuantityKindCount = 18;

/// Every kind, in the order of the enumeration.
std::span<const QuantityKind> all_quantity_kinds();

/// The dimension of the SI unit of a kind: length 1, mass 1, time -2 for a force.
Dimension dimension_of(QuantityKind kind);

/// "angular velocity".
std::string_view name_of(QuantityKind kind);

/// "an angular velocity"; "a bare number" for dimensionless.
std::string_view phrase_of(QuantityKind kind);

/// Whether it is one of the magnitudes of a network: a rate or an action.
bool is_magnitude(QuantityKind kind);

/// The key of the section `units:` ("angular_velocity"); empty where the unit is not the user's
/// choice because it follows from others.
std::string_view key_of(QuantityKind kind);

/// What one may type at such a place, for hints: "30 deg or 0.52 rad".
std::string_view example_of(QuantityKind kind);

/// A dimension in words for messages: "a length", "a bare number", "a quantity in kg*m^2/s".
std::string phrase_of(const Dimension& dimension);

/// The coherent SI unit of a dimension in base units: "kg*m^2/s", "1" for a bare number.
std::string si_unit_of(const Dimension& dimension);

/// Whether a value of this dimension may stand where the kind is expected, its radians counting as
/// one. An angle must be an angle, an angular velocity or acceleration an angle per time or its
/// square; elsewhere the exponent
/// of the angle is free: N*m/rad is a moment, 20 deg * 5 mm a length. A bare number fits only
/// `dimensionless`; that it takes the unit of the file elsewhere is the business of fit.
bool fits(const Dimension& dimension, QuantityKind kind);

}  // namespace kinestat
