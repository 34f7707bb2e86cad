// Where the weights of equal planets act together.
#pragma once

#include <string_view>

#include "core/index.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/gears/gear_layout.hpp"

namespace kinestat {

/// Two or more equal planets at equal angles have their centre of mass on the axis about which
/// their carrier turns, wherever they stand and however they are balanced: the point of that axis
/// that is level with `centre`, both from the origin of the evaluator. `body` is a planet.
template <class Scalar>
Vec3Of<Scalar> place_of_planet_weights(const GearLayoutOf<Scalar>& layout,
                                       std::string_view body,
                                       const EvaluatorOf<Scalar>& evaluator,
                                       const Vec3Of<Scalar>& centre) {
  const GearTrain& train = layout.train;
  const int about = train.axes[at(train.axis_on(body))].about;
  Vec3Of<Scalar> place = evaluator.from_origin(about < 0 ? Vec3Of<Scalar>(Vec3Of<Scalar>::Zero())
                                                         : layout.centres[at(about)]);
  place[2] = centre[2];
  return place;
}

}  // namespace kinestat
