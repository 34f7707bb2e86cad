// The units of bare numbers in one mechanism file, which its report uses too.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "expression/units.hpp"

namespace kinestat {

/// A unit as text, and its size.
struct NamedUnit {
  std::string text;  ///< empty for a bare number
  UnitScale scale;   ///< in SI
};

/// One unit for every kind of quantity. Defaults: m, rad, s, kg, kg*m^2, N, N*m, rad/s, rad/s^2, W,
/// N/m. Unless they
/// are set, velocity and acceleration follow length and time, pitch (length per radian) and lead
/// (length per turn) follow the length, angular stiffness follows the moment (per radian).
class FileUnits {
 public:
  FileUnits();

  /// Chooses the unit of a kind. Answers what is wrong with it, and then changes nothing: E0308 if
  /// it is not a unit, E0309 if it measures something else. Not for `dimensionless`.
  std::optional<ExpressionError> set(QuantityKind kind, std::string_view unit);

  /// The unit as text, "N*mm"; empty for dimensionless.
  const std::string& text(QuantityKind kind) const { return unit(kind).text; }

  /// The size of the unit in SI. A lead counts in metres per turn.
  const UnitScale& scale(QuantityKind kind) const { return unit(kind).scale; }

  /// SI per unit.
  double factor(QuantityKind kind) const { return unit(kind).scale.factor(); }

  /// The unit of a quantity that no place of the file defines, such as a parameter: that of the
  /// first kind of its dimension, else the SI unit.
  NamedUnit unit_of(const Dimension& dimension) const;

  /// A number in the file's unit, in SI.
  double to_si(QuantityKind kind, double value) const { return unit(kind).scale.to_si(value); }

  /// A value in SI, in the file's unit: what was typed as it was typed.
  double from_si(QuantityKind kind, double value) const {
    return unit(kind).scale.written_from_si(value);
  }

 private:
  struct Entry {
    UnitScale scale;
    std::string text;
    bool is_set = false;
  };

  const Entry& unit(QuantityKind kind) const { return units_[static_cast<std::size_t>(kind)]; }

  Entry& unit(QuantityKind kind) { return units_[static_cast<std::size_t>(kind)]; }

  void derive();
  void derive(QuantityKind kind, const UnitScale& scale, std::string text);

  std::array<Entry, kQuantityKindCount> units_;
};

}  // namespace kinestat
