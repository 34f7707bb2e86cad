#include "screw/bounded_screw.hpp"

#include "core/rounding.hpp"
#include "math/numbers/bounded_arithmetic.hpp"

namespace kinestat {

namespace {

// A line vector with its moment about the origin, as in the doubles.
struct Screw {
  BoundedVector line;
  BoundedVector moment;
};

Screw bounded_screw_of(const BoundedNumber& magnitude,
                       const Vec3& line,
                       const Vec3& moment,
                       const Vec3& point) {
  const double direction = line.cwiseAbs().maxCoeff();
  const double arm = point.cwiseAbs().sum() * direction + moment.cwiseAbs().maxCoeff();
  return {.line = bounded_product(
              magnitude, {.value = line, .bound = Vec3::Constant(kDataRounding * direction)}),
          .moment = bounded_product(
              magnitude, {.value = moment, .bound = Vec3::Constant(kDataRounding * arm)})};
}

BoundedVector at_of(const Vec3& point) {
  return rounded_vector(point, kDataRounding);
}

// p = s x m / s·s and h = s·m / s·s, see the doubles.
std::optional<ScrewAxis> axis_of(const BoundedVector& line,
                                 const BoundedVector& moment,
                                 double length) {
  const BoundedVector sure_line = {.value = line.zeroed(), .bound = line.bound};
  const std::optional<ScrewAxis> plain =
      find_axis(Twist{.angular = sure_line.value, .linear = moment.zeroed()}, length);
  if (!plain || !plain->point) {
    return plain;
  }
  const BoundedNumber one = {.value = 1.0, .bound = 0.0};
  const BoundedNumber square = dot(sure_line, sure_line);
  if (square.zeroed() == 0.0) {
    return std::nullopt;
  }
  return ScrewAxis{.direction = plain->direction,
                   .point = ((one / square) * cross(sure_line, moment)).zeroed(),
                   .pitch = (dot(sure_line, moment) / square).zeroed()};
}

}  // namespace

BoundedTwist operator-(const BoundedTwist& a, const BoundedTwist& b) {
  return {.angular = bounded_difference(a.angular, b.angular),
          .linear = bounded_difference(a.linear, b.linear)};
}

BoundedWrench operator+(const BoundedWrench& a, const BoundedWrench& b) {
  return {.moment = bounded_sum(a.moment, b.moment), .force = bounded_sum(a.force, b.force)};
}

BoundedTwist bounded_screw(const BoundedNumber& rate, const Twist& unit, const Vec3& point) {
  Screw screw = bounded_screw_of(rate, unit.angular, unit.linear, point);
  return {.angular = screw.line, .linear = screw.moment};
}

BoundedWrench bounded_screw(const BoundedNumber& magnitude, const Wrench& unit, const Vec3& point) {
  Screw screw = bounded_screw_of(magnitude, unit.force, unit.moment, point);
  return {.moment = screw.moment, .force = screw.line};
}

BoundedTwist written(const Twist& twist) {
  return {.angular = rounded_vector(twist.angular, kDataRounding),
          .linear = rounded_vector(twist.linear, kDataRounding)};
}

BoundedWrench written(const Wrench& wrench) {
  return {.moment = rounded_vector(wrench.moment, kDataRounding),
          .force = rounded_vector(wrench.force, kDataRounding)};
}

BoundedVector velocity_at(const BoundedTwist& twist, const Vec3& point) {
  return twist.linear + cross(twist.angular, at_of(point));
}

BoundedVector moment_at(const BoundedWrench& wrench, const Vec3& point) {
  return wrench.moment - cross(at_of(point), wrench.force);
}

BoundedTwist about_world(const BoundedTwist& twist, const LocalOrigin& origin) {
  return {.angular = twist.angular, .linear = velocity_at(twist, -origin.place())};
}

BoundedWrench about_world(const BoundedWrench& wrench, const LocalOrigin& origin) {
  return {.moment = moment_at(wrench, -origin.place()), .force = wrench.force};
}

BoundedNumber power(const BoundedWrench& wrench, const BoundedTwist& twist) {
  return bounded_sum(bounded_dot(wrench.moment, twist.angular),
                     bounded_dot(wrench.force, twist.linear));
}

std::optional<ScrewAxis> find_axis(const BoundedTwist& twist, double length) {
  return axis_of(twist.angular, twist.linear, length);
}

std::optional<ScrewAxis> find_axis(const BoundedWrench& wrench, double length) {
  return axis_of(wrench.force, wrench.moment, length);
}

}  // namespace kinestat
