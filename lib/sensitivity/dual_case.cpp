#include "sensitivity/dual_case.hpp"

#include <algorithm>

namespace kinestat {

DualCase::DualCase(const Mechanism& mechanism,
                   std::size_t case_index,
                   const KinematicSolution* motion,
                   const StaticSolution* action,
                   const MechanismDerivatives& derivatives)
    : mechanism_(mechanism),
      case_index_(case_index),
      motion_(motion),
      action_(action),
      derivatives_(derivatives),
      steps_(mechanism.topology.bodies.size()) {
  std::vector<std::vector<Step>> steps_from(steps_.size());
  for (const int e : mechanism.graph.tree.branches) {
    const CouplingTopology& edge = topology().couplings[static_cast<std::size_t>(e)];
    steps_from[static_cast<std::size_t>(edge.tail.value)].push_back({e, true});
    steps_from[static_cast<std::size_t>(edge.head.value)].push_back({e, false});
  }
  std::vector<int> waiting = {0};
  while (!waiting.empty()) {
    const int from = waiting.back();
    waiting.pop_back();
    for (const Step& step : steps_from[static_cast<std::size_t>(from)]) {
      const CouplingTopology& edge = topology().couplings[static_cast<std::size_t>(step.coupling)];
      const int to = step.forward ? edge.head.value : edge.tail.value;
      Step& known = steps_[static_cast<std::size_t>(to)];
      if (to != 0 && known.coupling < 0) {
        known = step;
        waiting.push_back(to);
      }
    }
  }
}

std::size_t DualCase::variable_count() const {
  return topology().freedoms.size() + topology().actions.size() + parameter_count();
}

Dual DualCase::rate(std::size_t freedom) const {
  return make_variable(motion_->rates[freedom], freedom, variable_count());
}

std::optional<Dual> DualCase::magnitude(std::size_t action) const {
  const std::optional<double>& magnitude = action_->magnitudes[action];
  return magnitude ? std::optional(make_variable(
                         *magnitude, topology().freedoms.size() + action, variable_count()))
                   : std::nullopt;
}

// The derivatives towards parameters come last.
Dual DualCase::placed(const Dual& dimension) const {
  Dual result(dimension.value);
  if (!dimension.derivatives.empty()) {
    result.derivatives.resize(variable_count() - parameter_count(), 0.0);
    result.derivatives.insert(
        result.derivatives.end(), dimension.derivatives.begin(), dimension.derivatives.end());
  }
  return result;
}

Vec3Of<Dual> DualCase::placed(const Vec3Of<Dual>& vector) const {
  return {placed(vector[0]), placed(vector[1]), placed(vector[2])};
}

TwistOf<Dual> DualCase::coupling_twist(std::size_t coupling) const {
  const CouplingTopology& edge = topology().couplings[coupling];
  TwistOf<Dual> sum;
  for (int i = edge.first_freedom; i < edge.first_freedom + edge.freedom_count; ++i) {
    const auto f = static_cast<std::size_t>(i);
    const TwistOf<Dual>& unit = derivatives_.geometry.motions[f];
    sum = sum +
          rate(f) * TwistOf<Dual>{.angular = placed(unit.angular), .linear = placed(unit.linear)};
  }
  return sum;
}

TwistOf<Dual> DualCase::body_twist(std::size_t body) const {
  TwistOf<Dual> sum;
  while (body != 0) {
    const Step& step = steps_[body];
    const CouplingTopology& edge = topology().couplings[static_cast<std::size_t>(step.coupling)];
    const TwistOf<Dual> twist = coupling_twist(static_cast<std::size_t>(step.coupling));
    sum = step.forward ? sum + twist : sum - twist;
    body = static_cast<std::size_t>(step.forward ? edge.tail.value : edge.head.value);
  }
  return sum;
}

std::optional<WrenchOf<Dual>> DualCase::coupling_wrench(std::size_t coupling) const {
  const CouplingTopology& edge = topology().couplings[coupling];
  WrenchOf<Dual> sum;
  for (int i = edge.first_action; i < edge.first_action + edge.action_count; ++i) {
    const auto a = static_cast<std::size_t>(i);
    const std::optional<Dual> size = magnitude(a);
    if (!size) {
      return std::nullopt;
    }
    const WrenchOf<Dual>& unit = derivatives_.geometry.actions[a];
    sum = sum + *size * WrenchOf<Dual>{.moment = placed(unit.moment), .force = placed(unit.force)};
  }
  return sum;
}

Vec3Of<Dual> DualCase::point(std::size_t coupling) const {
  return placed(derivatives_.geometry.points[coupling]);
}

Vec3Of<Dual> DualCase::reference(std::size_t body) const {
  return placed(derivatives_.geometry.references[body]);
}

}  // namespace kinestat
