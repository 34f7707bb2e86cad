#include "studies/duty/case_motions.hpp"

#include "kinematics/bounded_motion.hpp"
#include "kinematics/velocity.hpp"
#include "network/bases.hpp"

namespace kinestat {

CaseMotions::CaseMotions(const Mechanism& mechanism, const Case& which) {
  const CoordinateBasis basis = motion_basis(mechanism.geometry, mechanism.kinematic_order);
  std::vector<Primary> known = which.motions;
  for (Primary& primary : known) {
    primary.value = 0.0;
  }
  for (Primary& primary : known) {
    primary.value = 1.0;
    units_.push_back(solve_velocity(mechanism, basis, known));
    is_solved_ = is_solved_ && units_.back().status == SolveStatus::solved;
    primary.value = 0.0;
  }
}

double CaseMotions::rate(int freedom, std::span<const double> known) const {
  BoundedNumber sum;
  for (std::size_t i = 0; i < units_.size(); ++i) {
    if (known[i] != 0.0) {
      sum = sum + BoundedNumber{.value = known[i]} * bounded_rate(units_[i], freedom);
    }
  }
  return sum.zeroed();
}

Vec3 CaseMotions::turning(BodyId body, BodyId base, std::span<const double> known) const {
  BoundedVector sum;
  for (std::size_t i = 0; i < units_.size(); ++i) {
    if (known[i] != 0.0) {
      const BoundedTwist relative = bounded_body(units_[i], body) - bounded_body(units_[i], base);
      sum = sum + BoundedNumber{.value = known[i]} * relative.angular;
    }
  }
  return sum.zeroed();
}

Twist CaseMotions::body(BodyId body, std::span<const double> known) const {
  Twist sum;
  for (std::size_t i = 0; i < units_.size(); ++i) {
    sum = sum + known[i] * units_[i].bodies[static_cast<std::size_t>(body.value)];
  }
  return sum;
}

}  // namespace kinestat
