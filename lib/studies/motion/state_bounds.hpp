// How far the positions, velocities and accelerations of a state may be off.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "screw/twist.hpp"

namespace kinestat {

/// Of any component of the motion of a body, its twists being about the origin of the network.
struct BodyBounds {
  double turn = 0.0;          ///< [rad]
  double shift = 0.0;         ///< of the point at the origin [m]
  double angular = 0.0;       ///< [rad/s]
  double linear = 0.0;        ///< [m/s]
  double angular_rate = 0.0;  ///< [rad/s²]
  double linear_rate = 0.0;   ///< [m/s²]
};

/// SI; lists are parallel to the topology.
struct StateBounds {
  std::vector<double> positions;    ///< of the freedoms
  std::vector<double> rates;        ///< likewise
  std::vector<double> rate_rates;   ///< likewise
  std::vector<BodyBounds> bodies;   ///< empty: no bounds were asked for
  double rate_rounding = 0.0;       ///< a bound of a rate that is no larger is rounding [rad/s]
  double rate_rate_rounding = 0.0;  ///< likewise of its derivative [rad/s²]
  double reach = 0.0;               ///< no joint is farther from the origin of the network [m]
  double place = 0.0;               ///< of any body, in sizes of the mechanism
};

/// Zero where its bound is no more than rounding and does not tell it from zero, otherwise as it
/// is.
double settled_rate(double value, double bound, double rounding);

Vec3 settled_rates(const Vec3& value, double bound, double rounding);

/// Of freedoms: makes zero what the bounds do not tell from it.
void settle_positions(const StateBounds& bounds, std::vector<std::optional<double>>& positions);

/// Whether a value that was set to zero says anything. One whose bound is larger than itself,
/// and more than rounding, may be anything within it, and is not reported.
inline bool is_reported(double settled_value, double bound) {
  return settled_value == 0.0 || !(std::abs(settled_value) <= bound);
}

/// Of a point of a body, at `arm` from the origin of the network [m].
double position_bound(const BodyBounds& body, const Vec3& arm, const Vec3& position);

/// Of its velocity [m/s].
double velocity_bound(const BodyBounds& body,
                      const Vec3& arm,
                      const Vec3& position,
                      const Twist& twist);

/// Of its acceleration [m/s²].
double acceleration_bound(const BodyBounds& body,
                          const Vec3& arm,
                          const Vec3& position,
                          const Twist& twist,
                          const Twist& twist_rate);

}  // namespace kinestat
