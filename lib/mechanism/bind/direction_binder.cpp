#include "mechanism/bind/direction_binder.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/check/geometry_check.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

template <class Scalar>
std::string DirectionBinder<Scalar>::title() const {
  return fmt::format("{} '{}'", word_of(coupling_.type), coupling_.name.text);
}

template <class Scalar>
void DirectionBinder<Scalar>::refuse(SourceRange where, std::string message, std::string hint) {
  found_.error("E0314", where, std::move(message), std::move(hint));
}

template <class Scalar>
bool DirectionBinder<Scalar>::check_in_plane(const AxisOf<Scalar>& axis,
                                             SourceRange where,
                                             DirectionRole role) {
  const Vec3 direction = values_of<Scalar>(axis.direction);
  const bool turns = role == DirectionRole::turning;
  const double out_of_place = turns ? direction.head<2>().norm() : std::abs(direction.z());
  if (space_ == Space::spatial || out_of_place <= kZeroAxis) {
    return true;
  }
  refuse(where,
         turns ? fmt::format("{} of a planar mechanism turns about z", title())
         : takes(kind_of(coupling_.type), CouplingKey::sliding_axis)
             ? fmt::format("{} of a planar mechanism slides in the plane", title())
             : fmt::format("a direction of {} leaves the plane", title()),
         turns ? "remove 'axis', or write 'space: spatial' at the top of the file"
               : "write x, y or a vector [x, y]");
  return false;
}

template <class Scalar>
std::optional<AxisOf<Scalar>> DirectionBinder<Scalar>::bind(const AxisDescription& direction,
                                                            DirectionRole role) {
  const std::optional<AxisOf<Scalar>> axis = evaluator_.axis(direction);
  return axis && check_in_plane(*axis, direction.where, role) ? axis : std::nullopt;
}

template <class Scalar>
std::optional<AxisOf<Scalar>> DirectionBinder<Scalar>::bind(
    const std::optional<AxisDescription>& direction,
    std::string_view key,
    DirectionRole role,
    std::string_view hint) {
  if (direction) {
    return bind(*direction, role);
  }
  const bool is_about_z = space_ == Space::planar && role == DirectionRole::turning;
  if (is_about_z || is_counted_only(coupling_)) {
    return AxisOf<Scalar>{};
  }
  refuse(
      coupling_.name.where, fmt::format("{} lacks the key '{}'", title(), key), std::string(hint));
  return std::nullopt;
}

template <class Scalar>
bool DirectionBinder<Scalar>::check_perpendicular(const AxisOf<Scalar>& a,
                                                  const AxisOf<Scalar>& b,
                                                  SourceRange where,
                                                  std::string_view message,
                                                  std::string_view hint) {
  const Vec3 first = values_of<Scalar>(a.direction);
  const Vec3 second = values_of<Scalar>(b.direction);
  if (std::abs(first.dot(second)) <= kCancellation) {
    return true;
  }
  refuse(where, std::string(message), std::string(hint));
  return false;
}

template class DirectionBinder<double>;
template class DirectionBinder<Dual>;
template class DirectionBinder<ExactInput>;

}  // namespace kinestat
