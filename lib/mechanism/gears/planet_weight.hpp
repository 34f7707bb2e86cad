// The places at which the weights of gears act.
#pragma once

#include <string_view>

#include "core/index.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/gears/gear_layout.hpp"

namespace kinestat {

/// The point at z = 0 of an axis of the train, measured from the origin of the evaluator [m].
/// `axis` is its index, or -1 for the main axis.
template <class Scalar>
Vec3Of<Scalar> place_on_axis(const GearLayoutOf<Scalar>& layout,
                             int axis,
                             const EvaluatorOf<Scalar>& evaluator) {
  return evaluator.from_origin(axis < 0 ? Vec3Of<Scalar>(Vec3Of<Scalar>::Zero())
                                        : layout.centres[at(axis)]);
}

/// The centre of mass of two or more equal planets at equal angles [m], from the origin of the
/// evaluator. It is on the axis of their carrier, whatever their angles and their own balance, at
/// the z of `centre`. `body` is one of the planets.
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
