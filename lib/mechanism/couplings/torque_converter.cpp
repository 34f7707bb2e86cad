#include "mechanism/couplings/torque_converter.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <variant>

#include "core/rounding.hpp"
#include "math/dense/interpolation.hpp"
#include "math/numbers/dual.hpp"

namespace kinestat {

template <class Scalar>
std::optional<Scalar> CharacteristicCurveOf<Scalar>::value(const Scalar& speed_ratio) const {
  if (law) {
    const std::array variables = {
        LawVariable<Scalar>{.name = kSpeedRatio, .value = {.value = speed_ratio, .dimension = {}}}};
    const auto found = law->at(variables);
    const Scalar* const number = std::get_if<Scalar>(&found);
    return number != nullptr ? std::optional(*number) : std::nullopt;
  }
  const double x = value_of(speed_ratio);
  // A quotient of speeds may miss an end by its rounding.
  const double rounding =
      kSolvedRounding * std::max(std::abs(value_of(at.front())), std::abs(value_of(at.back())));
  if (!(x >= value_of(at.front()) - rounding && x <= value_of(at.back()) + rounding)) {
    return std::nullopt;
  }
  std::size_t i = 0;
  while (i + 2 < at.size() && x > value_of(at[i + 1])) {
    ++i;
  }
  const std::span<const Scalar> places = at;
  const std::span<const Scalar> heights = values;
  const Secant<Scalar> one = secant(places, heights, i);
  return hermite(values[i],
                 one,
                 monotone_slope(places, heights, i),
                 monotone_slope(places, heights, i + 1),
                 Scalar((speed_ratio - at[i]) / one.width));
}

template <class Scalar>
std::optional<ConverterPointOf<Scalar>> ConverterLawOf<Scalar>::point(
    const Scalar& pump_speed, const Scalar& turbine_speed) const {
  const double slip = value_of(turbine_speed) - value_of(pump_speed);
  if (std::abs(slip) <= kCancellation * std::abs(value_of(pump_speed))) {
    return ConverterPointOf<Scalar>{.speed_ratio = 1.0};
  }
  if (value_of(pump_speed) == 0.0) {
    return std::nullopt;
  }
  ConverterPointOf<Scalar> result{.speed_ratio = turbine_speed / pump_speed};
  const std::optional<Scalar> now = capacity.value(result.speed_ratio);
  const std::optional<Scalar> ratio =
      torque_ratio ? torque_ratio->value(result.speed_ratio) : Scalar(1.0);
  if (!now || !ratio) {
    return std::nullopt;
  }
  result.torque_ratio = *ratio;
  result.pump_torque = *now * scale * pump_speed * pump_speed;
  const double lost = value_of(result.pump_torque) *
                      (1.0 - value_of(result.torque_ratio) * value_of(result.speed_ratio));
  return lost >= -kDataRounding * std::abs(value_of(result.pump_torque)) ? std::optional(result)
                                                                         : std::nullopt;
}

template <class Scalar>
std::optional<Scalar> ConverterLawOf<Scalar>::couple(const Scalar& pump_speed,
                                                     const Scalar& turbine_speed) const {
  const std::optional<ConverterPointOf<Scalar>> now = point(pump_speed, turbine_speed);
  if (!now) {
    return std::nullopt;
  }
  const Scalar sense = value_of(pump_speed) < 0.0 ? -1.0 : 1.0;
  return is_of_stator ? sense * (now->torque_ratio - Scalar(1.0)) * now->pump_torque
                      : sense * now->pump_torque;
}

template struct CharacteristicCurveOf<double>;
template struct CharacteristicCurveOf<Dual>;
template struct ConverterLawOf<double>;
template struct ConverterLawOf<Dual>;

}  // namespace kinestat
