#include "mechanism/cables/internal/cable_station_binder.hpp"

#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

template <class Scalar>
bool bind_points(const CableStation& station,
                 EvaluatorOf<Scalar>& evaluator,
                 CableStationGeometryOf<Scalar>& result) {
  if (station.points.size() != 2) {
    return true;
  }
  result.meets = evaluator.point(station.points[0]);
  result.leaves = evaluator.point(station.points[1]);
  return result.meets && result.leaves;
}

template <class Scalar>
bool bind_axis(const CableStation& station,
               EvaluatorOf<Scalar>& evaluator,
               CableStationGeometryOf<Scalar>& result) {
  if (!station.axis) {
    return true;
  }
  const std::optional<AxisOf<Scalar>> axis = evaluator.axis(*station.axis);
  result.axis = axis ? axis->direction : result.axis;
  return axis.has_value();
}

template <class Scalar>
bool bind_radius(const CableStation& station,
                 EvaluatorOf<Scalar>& evaluator,
                 CableStationGeometryOf<Scalar>& result) {
  if (!station.radius || !station.wrap) {
    return true;
  }
  const std::optional<Scalar> radius = evaluator.number(*station.radius, QuantityKind::length);
  const Scalar sense = *station.wrap == Wrap::counterclockwise ? 1.0 : -1.0;
  result.radius = radius ? sense * *radius : Scalar(0.0);
  return radius.has_value();
}

}  // namespace

template <class Scalar>
std::optional<CableStationGeometryOf<Scalar>> bind_station(const CableStation& station,
                                                           EvaluatorOf<Scalar>& evaluator) {
  CableStationGeometryOf<Scalar> result;
  if (station.at) {
    const std::optional<Vec3Of<Scalar>> centre = evaluator.point(*station.at);
    if (!centre) {
      return std::nullopt;
    }
    result.centre = *centre;
  } else if (station.points.empty()) {
    return std::nullopt;
  }
  if (!station.is_pulley) {
    return result;
  }
  const bool is_good = bind_points<Scalar>(station, evaluator, result) &&
                       bind_axis<Scalar>(station, evaluator, result) &&
                       bind_radius<Scalar>(station, evaluator, result);
  return is_good ? std::optional(result) : std::nullopt;
}

template std::optional<CableStationGeometry> bind_station(const CableStation&, Evaluator&);
template std::optional<CableStationGeometryOf<Dual>> bind_station(const CableStation&,
                                                                  EvaluatorOf<Dual>&);
template std::optional<CableStationGeometryOf<ExactInput>> bind_station(const CableStation&,
                                                                        EvaluatorOf<ExactInput>&);

}  // namespace kinestat
