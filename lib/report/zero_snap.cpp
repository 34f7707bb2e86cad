#include "report/zero_snap.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

double largest(double so_far, const Vec3& vector) {
  return std::max(so_far, vector.cwiseAbs().maxCoeff());
}

void snap_motions(const KinematicSolution& motion, double length, ZeroSnap& result) {
  double angular = 0.0;
  double linear = 0.0;
  for (const Twist& twist : motion.bodies) {
    angular = largest(angular, twist.angular);
    linear = largest(linear, twist.linear);
  }
  for (const Twist& twist : motion.couplings) {
    angular = largest(angular, twist.angular);
    linear = largest(linear, twist.linear);
  }
  result.angular = kReportZero * std::max(angular, linear / length);
  result.linear = kReportZero * std::max(linear, angular * length);
}

void snap_actions(const CaseAnalysis& analysis, double length, ZeroSnap& result) {
  double moment = 0.0;
  double force = 0.0;
  for (const std::optional<Wrench>& wrench : analysis.action->wrenches) {
    moment = largest(moment, wrench.value_or(Wrench{}).moment);
    force = largest(force, wrench.value_or(Wrench{}).force);
  }
  for (const Load& load : analysis.which.loads) {
    moment = largest(moment, load.acts.wrench.moment);
    force = largest(force, load.acts.wrench.force);
  }
  result.moment = kReportZero * std::max(moment, force * length);
  result.force = kReportZero * std::max(force, moment / length);
}

}  // namespace

ZeroSnap find_zero_snap(const CaseAnalysis& analysis, double length) {
  ZeroSnap result;
  if (analysis.motion) {
    snap_motions(*analysis.motion, length, result);
  }
  if (analysis.action) {
    snap_actions(analysis, length, result);
  }
  if (analysis.power) {
    double most = 0.0;
    const PowerFlow& flow = *analysis.power;
    for (const std::optional<double>& value : flow.into_head) {
      most = std::max(most, std::abs(value.value_or(0.0)));
    }
    for (const auto* powers : {&flow.supplied, &flow.loads}) {
      for (const double value : *powers) {
        most = std::max(most, std::abs(value));
      }
    }
    result.power = kReportZero * most;
  }
  return result;
}

double snap(double value, double threshold) {
  return std::abs(value) <= threshold ? 0.0 : value;
}

}  // namespace kinestat
