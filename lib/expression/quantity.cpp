#include "expression/quantity.hpp"

#include <array>

#include <fmt/format.h>

namespace kinestat {

namespace {

struct KindRow {
  QuantityKind kind = QuantityKind::dimensionless;
  Dimension dimension;  // length, mass, time, angle
  std::string_view name;
  std::string_view phrase;
  std::string_view key;
  std::string_view example;
};

// In the order of the enumeration: row_of indexes.
constexpr std::array<KindRow, kQuantityKindCount> list_rows() {
  using enum QuantityKind;
  return {{
      {dimensionless,
       {0, 0, 0, 0},
       "bare number",
       "a bare number",
       "",
       "the number without a unit"},
      {length, {1, 0, 0, 0}, "length", "a length", "length", "5 mm or 0.005 m"},
      {angle, {0, 0, 0, 1}, "angle", "an angle", "angle", "30 deg or 0.52 rad"},
      {time, {0, 0, 1, 0}, "time", "a time", "time", "2 s or 0.5 min"},
      {mass, {0, 1, 0, 0}, "mass", "a mass", "mass", "2 kg or 500 g"},
      {inertia,
       {2, 1, 0, 0},
       "moment of inertia",
       "a moment of inertia",
       "inertia",
       "0.002 kg*m^2 or 2000 kg*mm^2"},
      {force, {1, 1, -2, 0}, "force", "a force", "force", "100 N or 0.1 kN"},
      {moment, {2, 1, -2, 0}, "moment", "a moment", "moment", "5 N*m or 5000 N*mm"},
      {velocity, {1, 0, -1, 0}, "velocity", "a velocity", "velocity", "1 m/s or 20 mm/s"},
      {angular_velocity,
       {0, 0, -1, 1},
       "angular velocity",
       "an angular velocity",
       "angular_velocity",
       "1 rad/s or 1500 rpm"},
      {acceleration, {1, 0, -2, 0}, "acceleration", "an acceleration", "", "9.81 m/s^2"},
      {angular_acceleration,
       {0, 0, -2, 1},
       "angular acceleration",
       "an angular acceleration",
       "",
       "50 rad/s^2"},
      {power, {2, 1, -3, 0}, "power", "a power", "power", "500 W or 0.5 kW"},
      {energy, {2, 1, -2, 0}, "energy", "an energy", "energy", "5 J or 0.2 kWh"},
      {stiffness, {0, 1, -2, 0}, "stiffness", "a stiffness", "stiffness", "2e6 N/m"},
      {angular_stiffness,
       {2, 1, -2, -1},
       "angular stiffness",
       "an angular stiffness",
       "",
       "300 N*m/rad"},
      {pitch,
       {1, 0, 0, -1},
       "length per radian",
       "a length per radian",
       "",
       "2 mm/rad or 5 mm/rev"},
      {lead, {1, 0, 0, 0}, "length per turn", "a length per turn", "", "5 mm or 5 mm/rev"},
  }};
}

constexpr auto kKindRows = list_rows();

constexpr std::array<QuantityKind, kQuantityKindCount> list_kinds() {
  std::array<QuantityKind, kQuantityKindCount> kinds{};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    kinds[i] = kKindRows[i].kind;
  }
  return kinds;
}

constexpr auto kAllKinds = list_kinds();

const KindRow& row_of(QuantityKind kind) {
  return kKindRows[static_cast<std::size_t>(kind)];
}

// "*m^2" for exponent 2, with the sign in front of the unit as asked.
std::string factor_text(std::string_view sign, std::string_view unit, int exponent) {
  if (exponent <= 0) {
    return {};
  }
  return exponent == 1 ? fmt::format("{}{}", sign, unit)
                       : fmt::format("{}{}^{}", sign, unit, exponent);
}

Dimension without_angle(Dimension dimension) {
  dimension.angle = 0;
  return dimension;
}

}  // namespace

Dimension operator*(const Dimension& a, const Dimension& b) {
  return {a.length + b.length, a.mass + b.mass, a.time + b.time, a.angle + b.angle};
}

Dimension operator/(const Dimension& a, const Dimension& b) {
  return {a.length - b.length, a.mass - b.mass, a.time - b.time, a.angle - b.angle};
}

Dimension power(const Dimension& base, int exponent) {
  return {
      base.length * exponent, base.mass * exponent, base.time * exponent, base.angle * exponent};
}

bool is_bare(const Dimension& dimension) {
  return dimension == Dimension{};
}

std::span<const QuantityKind> all_quantity_kinds() {
  return kAllKinds;
}

Dimension dimension_of(QuantityKind kind) {
  return row_of(kind).dimension;
}

std::string_view name_of(QuantityKind kind) {
  return row_of(kind).name;
}

bool is_magnitude(QuantityKind kind) {
  using enum QuantityKind;
  return kind == velocity || kind == angular_velocity || kind == force || kind == moment;
}

std::string_view phrase_of(QuantityKind kind) {
  return row_of(kind).phrase;
}

std::string_view key_of(QuantityKind kind) {
  return row_of(kind).key;
}

std::string_view example_of(QuantityKind kind) {
  return row_of(kind).example;
}

// Divisors after the factors.
std::string si_unit_of(const Dimension& d) {
  const std::string above = factor_text("*", "kg", d.mass) + factor_text("*", "m", d.length) +
                            factor_text("*", "s", d.time) + factor_text("*", "rad", d.angle);
  const std::string below = factor_text("/", "kg", -d.mass) + factor_text("/", "m", -d.length) +
                            factor_text("/", "s", -d.time) + factor_text("/", "rad", -d.angle);
  return (above.empty() ? "1" : above.substr(1)) + below;
}

std::string phrase_of(const Dimension& dimension) {
  for (const KindRow& row : kKindRows) {
    if (row.dimension == dimension) {
      return std::string(row.phrase);
    }
  }
  return "a quantity in " + si_unit_of(dimension);
}

bool fits(const Dimension& dimension, QuantityKind kind) {
  const Dimension expected = dimension_of(kind);
  const bool is_exact = kind == QuantityKind::angular_velocity ||
                        kind == QuantityKind::angular_acceleration ||
                        is_bare(without_angle(expected));
  return is_exact ? dimension == expected : without_angle(dimension) == without_angle(expected);
}

}  // namespace kinestat
