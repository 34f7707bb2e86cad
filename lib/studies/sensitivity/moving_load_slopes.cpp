#include "studies/sensitivity/moving_load_slopes.hpp"

#include <algorithm>
#include <utility>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "dynamics/body_inertia.hpp"
#include "dynamics/spring_force.hpp"
#include "studies/sensitivity/internal/motion_slopes.hpp"

namespace kinestat {

namespace {

class LoadDifferentiator {
 public:
  LoadDifferentiator(const DualCase& values, const CaseDynamics* dynamics)
      : values_(values), mechanism_(values.mechanism()), dynamics_(dynamics) {}

  std::variant<std::vector<WrenchOf<Dual>>, LoadSlopeObstacle> run() {
    if (dynamics_ == nullptr) {
      motion_ = velocity_slopes(values_);
    } else {
      AccelerationSlopes found = acceleration_slopes(values_);
      if (found.without_law) {
        return LoadSlopeObstacle{.coupling = found.without_law};
      }
      motion_ = std::move(found.motion);
      if (!has_accelerations_of_case()) {
        return LoadSlopeObstacle{};
      }
    }
    add_springs();
    for (std::size_t b = 0; dynamics_ != nullptr && b < mechanism_.masses.size(); ++b) {
      if (mechanism_.masses[b].counts()) {
        loads_.push_back(inertial_wrench(
            values_.derivatives().masses[b], motion_.twists[b], motion_.twist_rates[b]));
      }
    }
    return std::move(loads_);
  }

 private:
  // The finite laws of the couplings are the second way to them.
  bool has_accelerations_of_case() const {
    double angular = 0.0;
    double angular_miss = 0.0;
    double linear = 0.0;
    double linear_miss = 0.0;
    for (const BodyDynamics& body : dynamics_->bodies) {
      const auto b = at(body.body.value);
      const Twist twist = {.angular = values_of(motion_.twists[b].angular),
                           .linear = values_of(motion_.twists[b].linear)};
      const Twist rate = {.angular = values_of(motion_.twist_rates[b].angular),
                          .linear = values_of(motion_.twist_rates[b].linear)};
      const BodyInertia inertia{.mass = 1.0, .centre = body.centre};
      angular = std::max(angular, rate.angular.norm() + twist.angular.squaredNorm());
      angular_miss = std::max(angular_miss, (rate.angular - body.angular_acceleration).norm());
      const Vec3 acceleration = centre_acceleration(inertia, twist, rate);
      linear = std::max(linear, acceleration.norm());
      linear_miss = std::max(linear_miss, (acceleration - body.centre_acceleration).norm());
    }
    linear = std::max(linear, angular * mechanism_.geometry.length);
    return angular_miss <= kConsistency * angular && linear_miss <= kConsistency * linear;
  }

  void add_springs() {
    for (std::size_t i = 0; i < mechanism_.springs.size(); ++i) {
      const Spring& spring = mechanism_.springs[i];
      const SpringNumbersOf<Dual>& numbers = values_.derivatives().springs[i];
      spring.is_of_freedom() ? add_of_freedom(spring, numbers) : add_between(spring, numbers);
    }
  }

  void add(BodyId body, const WrenchOf<Dual>& wrench) {
    if (body.value != 0) {
      loads_.push_back(wrench);
    }
  }

  void add_of_freedom(const Spring& spring, const SpringNumbersOf<Dual>& numbers) {
    const FreedomLabel& freedom = values_.topology().freedoms[at(spring.freedom)];
    const GeometryOf<Dual>& geometry = values_.derivatives().geometry;
    const TwistOf<Dual>& unit = geometry.motions[at(spring.freedom)];
    const Dual rate = motion_.rates.empty() ? Dual(0.0) : motion_.rates[at(spring.freedom)];
    const Dual action = action_of(numbers, Dual(0.0), rate);
    const Vec3Of<Dual> none = Vec3Of<Dual>::Zero();
    const WrenchOf<Dual> on_head =
        freedom.is_rotation
            ? WrenchOf<Dual>{.moment = action * unit.angular, .force = none}
            : action * unit_force<Dual>(unit.linear, geometry.points[at(freedom.coupling.value)]);
    add(spring.head, on_head);
    add(spring.tail, Dual(-1.0) * on_head);
  }

  void add_between(const Spring& spring, const SpringNumbersOf<Dual>& numbers) {
    const Vec3Of<Dual> pull = pull_of(spring, numbers);
    const Vec3Of<Dual> back = -pull;
    add(spring.head, {.moment = numbers.to.cross(back), .force = back});
    add(spring.tail, {.moment = numbers.from.cross(pull), .force = pull});
  }

  // Where the points meet, a spring has a direction only as they part: its tension is that times
  // its stiffness (spring_states).
  Vec3Of<Dual> pull_of(const Spring& spring, const SpringNumbersOf<Dual>& numbers) const {
    const Vec3Of<Dual> arm = numbers.to - numbers.from;
    Vec3Of<Dual> speed = Vec3Of<Dual>::Zero();
    if (!motion_.twists.empty()) {
      speed = velocity_at<Dual>(motion_.twists[at(spring.head.value)], numbers.to) -
              velocity_at<Dual>(motion_.twists[at(spring.tail.value)], numbers.from);
    }
    if (!(values_of(arm).norm() > kNoSpringLength * mechanism_.geometry.length)) {
      const bool pulls = spring.acts != SpringSense::push;
      return Dual(pulls ? 1.0 : 0.0) * (numbers.stiffness * arm + numbers.damping * speed);
    }
    const Dual length = sqrt(Dual(arm.squaredNorm()));
    const Dual rate = Dual(speed.dot(arm)) / length;
    return tension_of(numbers, spring.acts, length, rate) * unit_along(arm);
  }

  const DualCase& values_;
  const Mechanism& mechanism_;
  const CaseDynamics* dynamics_;
  MotionSlopes motion_;
  std::vector<WrenchOf<Dual>> loads_;
};

}  // namespace

std::variant<std::vector<WrenchOf<Dual>>, LoadSlopeObstacle> moving_load_slopes(
    const DualCase& values, const CaseDynamics* dynamics) {
  return LoadDifferentiator(values, dynamics).run();
}

}  // namespace kinestat
