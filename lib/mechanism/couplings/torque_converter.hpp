// The characteristic of a torque converter, bound to numbers.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/types.hpp"
#include "expression/number_law.hpp"

namespace kinestat {

/// The name, in a characteristic, of the angular velocity of the turbine over that of the pump,
/// both relative to the stator.
inline constexpr std::string_view kSpeedRatio = "speed_ratio";

/// A quantity as a function of the speed ratio: an expression, or a curve through the points of a
/// table. `Scalar` is double or Dual.
template <class Scalar>
struct CharacteristicCurveOf {
  std::vector<Scalar> at;      ///< speed ratios of the points, ascending; empty with an expression
  std::vector<Scalar> values;  ///< of the points
  std::optional<NumberLaw<Scalar>> law;

  /// The value at a speed ratio: cubic between points, and monotone where the points are
  /// (`monotone_slope`). Empty outside the table, and if the expression has no value.
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

/// The operating point of a converter.
template <class Scalar>
struct ConverterPointOf {
  Scalar speed_ratio = 0.0;
  Scalar torque_ratio = 1.0;  ///< of turbine to pump
  Scalar pump_torque = 0.0;   ///< taken by the pump, in its sense of rotation [N·m]; negative if
                              ///< the turbine drives the pump
};

/// The law of a torque converter (VDI 2153). The pump torque is capacity · scale · ω², ω being the
/// speed of the pump relative to the stator. The turbine torque is μ times the pump torque; the
/// stator bears the difference, μ - 1 times the pump torque. Without slip all torques are zero.
template <class Scalar>
struct ConverterLawOf {
  BodyId pump;
  BodyId turbine;
  BodyId stator;
  bool is_of_stator = false;  ///< whether this is the couple of the stator on the turbine;
                              ///< otherwise it is that of the pump on the turbine
  std::optional<CharacteristicCurveOf<Scalar>> torque_ratio;  ///< μ; empty: 1
  CharacteristicCurveOf<Scalar> capacity;
  Scalar scale = 1.0;

  /// The operating point at these speeds [rad/s]. Empty if the characteristic has no value there,
  /// or if the converter would give more power than it takes.
  std::optional<ConverterPointOf<Scalar>> point(const Scalar& pump_speed,
                                                const Scalar& turbine_speed) const;

  /// The couple of this law on the turbine [N·m], in the sense in which speeds count.
  std::optional<Scalar> couple(const Scalar& pump_speed, const Scalar& turbine_speed) const;

  /// The speed of the turbine relative to the other body of the law.
  Scalar slip(const Scalar& pump_speed, const Scalar& turbine_speed) const {
    return is_of_stator ? turbine_speed : Scalar(turbine_speed - pump_speed);
  }
};

using ConverterPoint = ConverterPointOf<double>;
using ConverterLaw = ConverterLawOf<double>;

}  // namespace kinestat
