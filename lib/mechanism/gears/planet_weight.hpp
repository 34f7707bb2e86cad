// Where the weights of gears act: on their axis, those of equal planets together.
#pragma once

#include <string_view>

#include "core/index.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/gears/gear_layout.hpp"

namespace kinestat {

/// The point at z = 0 of the axis about which a body of the train turns: from the origin of the
/// evaluator, as all places here.
template <class Scalar>
Vec3Of<Scalar> place_on_axis(const GearLayoutOf<Scalar>& layout,
                             int axis,
                             const EvaluatorOf<Scalar>& evaluator) {
  return evaluator.from_origin(axis < 0 ? Vec3Of<Scalar>(Vec3Of<Scalar>::Zero())
                                        : layout.centres[at(axis)]);
}

/// Two or more equal planets at equal angles have their centre of mass on the axis about which
/// their carrier turns, wherever they stand and however they are balanced: the point of that axis
/// that is level with `centre`. `body` is a planet.
template <class Scalar>
Vec3Of<Scalar> place_of_planet_weights(const GearLayoutOf<Scalar>& layout,
                                       std::string_view body,
                                       const EvaluatorOf<Scalar>& evaluator,
                                       const Vec3Of<Scalar>& centre) {
  const GearTrain& train = layout.train;
  Vec3Of<Scalar> place =
      place_on_axis(layout, train.axes[at(train.axis_on(body))].about, evaluator);
  place[2] = centre[2];
  return place;
}

}  // namespace kinestat
