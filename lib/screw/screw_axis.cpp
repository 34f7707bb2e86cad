#include "screw/screw_axis.hpp"

#include <cmath>

#include "core/rounding.hpp"
#include "math/numbers/bounded_number.hpp"

namespace kinestat {

namespace {

// A screw as a line vector s (ω or F) with its moment m about the origin (v_O or T_O):
// m = p x s + h s, so h = s·m / s·s and p = s x m / s·s.
std::optional<ScrewAxis> axis_of(const Vec3& line, const Vec3& moment, double length) {
  const double size = length * line.norm();
  const double moment_size = moment.norm();
  if (size == 0.0 && moment_size == 0.0) {
    return std::nullopt;
  }
  if (size <= kInfinitePitch * moment_size) {
    return ScrewAxis{
        .direction = moment.normalized(), .point = std::nullopt, .pitch = std::nullopt};
  }
  const double square = line.squaredNorm();
  const double along =
      dot(rounded_vector(line, kDataRounding), rounded_vector(moment, kDataRounding)).zeroed();
  return ScrewAxis{.direction = line.normalized(),
                   .point = line.cross(moment) / square,
                   .pitch = along / square};
}

}  // namespace

std::optional<ScrewAxis> find_axis(const Twist& twist, double length) {
  return axis_of(twist.angular, twist.linear, length);
}

std::optional<ScrewAxis> find_axis(const Wrench& wrench, double length) {
  return axis_of(wrench.force, wrench.moment, length);
}

}  // namespace kinestat
