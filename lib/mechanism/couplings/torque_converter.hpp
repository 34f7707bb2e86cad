// The characteristic of a torque converter, bound to numbers.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/types.hpp"
#include "expression/number_law.hpp"

namespace kinestat {

/// What the characteristic calls the angular velocity of the turbine over that of the pump, both
/// seen from the stator.
inline constexpr std::string_view kSpeedRatio = "speed_ratio";

/// A quantity over the speed ratio: an expression, or a curve through the points of a table.
/// `Scalar` is double or Dual.
template <class Scalar>
struct CharacteristicCurveOf {
  std::vector<Scalar> at;      ///< rising; empty with an expression
  std::vector<Scalar> values;  ///< at these
  std::optional<NumberLaw<Scalar>> law;

  /// Cubic between neighbours, as monotone as the points are (`monotone_slope`). Empty beyond the
  /// table, and where the expression has no value.
  std::optional<Scalar> value(const Scalar& speed_ratio) const;

  template <class Change>
  void change_numbers(Change change) {
    for (auto* numbers : {&at, &values}) {
      for (Scalar& number : *numbers) {
        number = change(number);
      }
    }
    if (law) {
      for (auto& parameter : law->parameters()) {
        parameter.second.value = change(parameter.second.value);
      }
    }
  }
};

/// What flows in a converter at some speeds.
template <class Scalar>
struct ConverterPointOf {
  Scalar speed_ratio = 0.0;
  Scalar torque_ratio = 1.0;  ///< of turbine to pump
  Scalar pump_torque = 0.0;   ///< that the pump takes, in the sense in which it turns [N·m];
                              ///< negative where the turbine drives it
};

/// Pump torque capacity · scale · ω², ω being the speed of the pump seen from the stator; turbine
/// torque μ times that, of which the stator holds μ - 1 (VDI 2153). Without slip nothing flows.
template <class Scalar>
struct ConverterLawOf {
  BodyId pump;
  BodyId turbine;
  BodyId stator;
  bool is_of_stator = false;  ///< the couple of stator on turbine; else that of pump on turbine
  std::optional<CharacteristicCurveOf<Scalar>> torque_ratio;  ///< μ; empty: 1
  CharacteristicCurveOf<Scalar> capacity;
  Scalar scale = 1.0;

  /// Empty where the characteristic has no value at these speeds [rad/s], or where it would give
  /// more power than it takes.
  std::optional<ConverterPointOf<Scalar>> point(const Scalar& pump_speed,
                                                const Scalar& turbine_speed) const;

  /// The couple of this law on the turbine, in the sense in which speeds count [N·m].
  std::optional<Scalar> couple(const Scalar& pump_speed, const Scalar& turbine_speed) const;

  /// How fast the turbine turns against the other body of the law.
  Scalar slip(const Scalar& pump_speed, const Scalar& turbine_speed) const {
    return is_of_stator ? turbine_speed : Scalar(turbine_speed - pump_speed);
  }
};

using ConverterPoint = ConverterPointOf<double>;
using ConverterLaw = ConverterLawOf<double>;

}  // namespace kinestat
