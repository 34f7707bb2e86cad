#include "mechanism/couplings/torque_converter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <variant>

#include "core/rounding.hpp"
#include "math/numbers/dual.hpp"

namespace kinestat {

namespace {

template <class Scalar>
struct Chord {
  Scalar width;
  Scalar slope;
};

template <class Scalar>
Chord<Scalar> chord(const CharacteristicCurveOf<Scalar>& curve, std::size_t i) {
  const Scalar width = curve.at[i + 1] - curve.at[i];
  return {.width = width, .slope = (curve.values[i + 1] - curve.values[i]) / width};
}

// Between two chords: their harmonic mean, weighted by their widths; none where they differ in
// sense.
template <class Scalar>
Scalar inner_slope(const Chord<Scalar>& a, const Chord<Scalar>& b) {
  if (value_of(a.slope) * value_of(b.slope) <= 0.0) {
    return 0.0;
  }
  const Scalar first = Scalar(2.0) * b.width + a.width;
  const Scalar second = b.width + Scalar(2.0) * a.width;
  return (first + second) / (first / a.slope + second / b.slope);
}

// At an end that the chord `a` begins, which `b` follows.
template <class Scalar>
Scalar end_slope(const Chord<Scalar>& a, const Chord<Scalar>& b) {
  const Scalar slope =
      ((Scalar(2.0) * a.width + b.width) * a.slope - a.width * b.slope) / Scalar(a.width + b.width);
  if (value_of(slope) * value_of(a.slope) <= 0.0) {
    return 0.0;
  }
  const bool turns = value_of(a.slope) * value_of(b.slope) <= 0.0;
  const bool is_steep = std::abs(value_of(slope)) > 3.0 * std::abs(value_of(a.slope));
  return turns && is_steep ? Scalar(Scalar(3.0) * a.slope) : slope;
}

template <class Scalar>
Scalar slope_at(const CharacteristicCurveOf<Scalar>& curve, std::size_t i) {
  const std::size_t last = curve.at.size() - 1;
  if (last == 1) {
    return chord(curve, 0).slope;
  }
  if (i == 0) {
    return end_slope(chord(curve, 0), chord(curve, 1));
  }
  return i == last ? end_slope(chord(curve, last - 1), chord(curve, last - 2))
                   : inner_slope(chord(curve, i - 1), chord(curve, i));
}

}  // namespace

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
  const Chord<Scalar> one = chord(*this, i);
  const Scalar t = (speed_ratio - at[i]) / one.width;
  const Scalar from = slope_at(*this, i);
  const Scalar to = slope_at(*this, i + 1);
  // Hermite: the chord, and how the slopes at its ends differ from its own.
  const Scalar rest = Scalar(1.0) - t;
  return values[i] + one.width * (t * one.slope +
                                  t * rest * (rest * (from - one.slope) - t * (to - one.slope)));
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
