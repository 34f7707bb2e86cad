#include "studies/motion/task/cycle/find_harmonics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "core/motion_tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "studies/motion/task/columns/dynamic_columns.hpp"

namespace kinestat {

namespace {

class HarmonicFinder {
 public:
  HarmonicFinder(CycleSampler& sampler, int orders)
      : sampler_(sampler), mechanism_(sampler.mechanism()), orders_(orders) {}

  std::variant<std::vector<HarmonicSeries>, CycleProblem> run() {
    for (const CycleMotor& motor : cycle_motors(sampler_)) {
      add_actuator(motor.actuator);
    }
    wrenches_ = dynamic_wrenches(mechanism_);
    for (const DynamicWrenchComponent& one : wrenches_) {
      series_.push_back({.name = one.element + "/" + one.quantity, .kind = one.kind, .orders = {}});
    }
    const auto found = sampler_.find([this](const MotionPosition& at) { return read(at); });
    if (!found) {
      return CycleProblem{
          "in some position of the cycle actions or the ground wrench have no value, or they jump "
          "too often, or rounding leaves them too few digits",
          "the rows of the motion say where"};
    }
    if (auto problem = why_not_closed(*found, mechanism_)) {
      return *std::move(problem);
    }
    for (std::size_t s = 0; s < series_.size(); ++s) {
      take_apart(*found, s);
    }
    return std::move(series_);
  }

 private:
  void add_actuator(int index) {
    const ActuatorTopology& actuator =
        mechanism_.topology.actuators[static_cast<std::size_t>(index)];
    const bool turns =
        mechanism_.topology.freedoms[static_cast<std::size_t>(actuator.freedom)].is_rotation;
    actions_.push_back(actuator.action);
    series_.push_back({.name = actuator.name + "/action",
                       .kind = turns ? QuantityKind::moment : QuantityKind::force,
                       .orders = {}});
  }

  std::optional<std::vector<CycleValue>> read(const MotionPosition& at) const {
    if (!at.solved || !at.solved->dynamics || !at.solved->action ||
        at.solved->action->magnitudes.empty()) {
      return std::nullopt;
    }
    const CaseDynamics& dynamics = *at.solved->dynamics;
    const double bias = dynamics.reduced.value().bias[0];
    std::vector<CycleValue> values;
    for (const int action : actions_) {
      const std::optional<double>& there =
          at.solved->action->magnitudes[static_cast<std::size_t>(action)];
      if (!there) {
        return std::nullopt;
      }
      values.push_back({.value = *there, .size = std::max(std::abs(*there), std::abs(bias))});
    }
    double force = 0.0;
    double moment = 0.0;
    for (const BodyDynamics& body : dynamics.bodies) {
      force += body.inertial.force.norm();
      moment += body.inertial.moment.norm();
    }
    for (const DynamicWrenchComponent& one : wrenches_) {
      const std::optional<double> there = one.value(dynamics);
      if (!there) {
        return std::nullopt;
      }
      const double size = one.kind == QuantityKind::force ? force : moment;
      values.push_back({.value = *there, .size = std::max(std::abs(*there), size)});
    }
    return values;
  }

  // The orders are by the turn of the drive, of which there may be several.
  void take_apart(const LegendrePieces& found, std::size_t s) {
    HarmonicSeries& one = series_[s];
    const double least = kNoHarmonic * found.size(s);
    one.mean = zero_within_bound(found.integral(s), least);
    const double way = sampler_.drive_at(1.0) - sampler_.drive_at(0.0);
    for (int order = 1; order <= orders_; ++order) {
      double cosine = 0.0;
      double sine = 0.0;
      const double eighth = 0.25 * std::numbers::pi / (order * std::abs(way));
      found.for_each_point(eighth, [&](double time, double weight, const VecX& values) {
        const double angle = order * sampler_.drive_at(time);
        const double value = 2.0 * weight * values[static_cast<Eigen::Index>(s)];
        cosine += value * std::cos(angle);
        sine += value * std::sin(angle);
      });
      const double amplitude = zero_within_bound(std::hypot(cosine, sine), least);
      one.orders.push_back(
          {.order = order,
           .amplitude = amplitude,
           .phase = amplitude > 0.0 ? std::optional(std::atan2(sine, cosine)) : std::nullopt});
    }
  }

  CycleSampler& sampler_;
  const Mechanism& mechanism_;
  int orders_ = 0;
  std::vector<int> actions_;
  std::vector<DynamicWrenchComponent> wrenches_;
  std::vector<HarmonicSeries> series_;
};

}  // namespace

std::variant<std::vector<HarmonicSeries>, CycleProblem> find_harmonics(CycleSampler& sampler,
                                                                       int orders) {
  return HarmonicFinder(sampler, orders).run();
}

}  // namespace kinestat
