#include "draw/linkage/file_numbers.hpp"

#include <cmath>
#include <variant>

#include "expression/evaluate.hpp"

namespace kinestat {

FileNumbers::FileNumbers(const MechanismDescription& description, const LocalOrigin& origin)
    : description_(description),
      origin_(origin),
      table_(evaluate_parameters(parameters_of(description)).table) {}

std::optional<double> FileNumbers::number(const Value& value, QuantityKind kind) const {
  const auto result =
      evaluate_as<double>(kind, value.expression, description_.units, table_.lookup());
  return std::holds_alternative<double>(result) ? std::optional(std::get<double>(result))
                                                : std::nullopt;
}

std::optional<Vec3> FileNumbers::point(const PointDescription& point) const {
  Vec3 result = Vec3::Zero();
  for (std::size_t i = 0; i < point.coordinates.size() && i < 3; ++i) {
    const std::optional<double> coordinate = number(point.coordinates[i], QuantityKind::length);
    if (!coordinate) {
      return std::nullopt;
    }
    result[static_cast<int>(i)] = *coordinate - origin_.place()[static_cast<int>(i)];
  }
  return result;
}

std::optional<Vec3> FileNumbers::direction(const AxisDescription& axis) const {
  Vec3 result = Vec3::Zero();
  if (axis.keyword != 0) {
    result[axis.keyword - 'x'] = axis.sign;
    return result;
  }
  for (std::size_t i = 0; i < axis.components.size() && i < 3; ++i) {
    const auto component = evaluate(axis.components[i].expression, table_.lookup());
    const Quantity* const found = std::get_if<Quantity>(&component);
    result[static_cast<int>(i)] = found != nullptr ? found->value : 0.0;
  }
  const double length = result.norm();
  return length > 0.0 ? std::optional<Vec3>(result / length) : std::nullopt;
}

std::optional<CableStationGeometry> FileNumbers::station(const CableStation& station) const {
  CableStationGeometry result;
  if (station.at) {
    result.centre = point(*station.at).value_or(result.centre);
  } else if (station.points.size() != 2) {
    return std::nullopt;
  }
  if (!station.is_pulley) {
    return result;
  }
  if (station.points.size() == 2) {
    result.meets = point(station.points[0]);
    result.leaves = point(station.points[1]);
  }
  if (station.axis) {
    result.axis = direction(*station.axis).value_or(result.axis);
  }
  if (station.radius && station.wrap) {
    const double sense = *station.wrap == Wrap::counterclockwise ? 1.0 : -1.0;
    result.radius = sense * number(*station.radius, QuantityKind::length).value_or(0.0);
  }
  return result;
}

}  // namespace kinestat
