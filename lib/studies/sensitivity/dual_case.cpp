#include "studies/sensitivity/dual_case.hpp"

#include <algorithm>

#include "core/contract.hpp"

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
  if (action != nullptr) {
    laws_.resize(action->friction.size());
    std::ranges::transform(action->friction, laws_.begin(), [&](const FrictionAction& one) {
      return law_of(one.coupling);
    });
  }
}

std::size_t DualCase::first_parameter() const {
  return topology().freedoms.size() + topology().actions.size() + friction_count();
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

std::optional<Dual> DualCase::real_magnitude(std::size_t action) const {
  return is_by_convention(*action_, static_cast<int>(action)) ? std::nullopt : magnitude(action);
}

// The derivatives towards parameters come last.
Dual DualCase::placed(const Dual& dimension) const {
  Dual result(dimension.value);
  if (!dimension.derivatives.empty()) {
    result.derivatives.resize(first_parameter(), 0.0);
    result.derivatives.insert(
        result.derivatives.end(), dimension.derivatives.begin(), dimension.derivatives.end());
  }
  return result;
}

Vec3Of<Dual> DualCase::placed(const Vec3Of<Dual>& vector) const {
  return {placed(vector[0]), placed(vector[1]), placed(vector[2])};
}

WrenchOf<Dual> DualCase::placed(const WrenchOf<Dual>& wrench) const {
  return {.moment = placed(wrench.moment), .force = placed(wrench.force)};
}

TwistOf<Dual> DualCase::unit_motion(std::size_t freedom) const {
  const TwistOf<Dual>& unit = derivatives_.geometry.motions[freedom];
  return {.angular = placed(unit.angular), .linear = placed(unit.linear)};
}

WrenchOf<Dual> DualCase::unit_action(std::size_t action) const {
  return placed(derivatives_.geometry.actions[action]);
}

Dual DualCase::friction(std::size_t friction) const {
  return make_variable(action_->friction[friction].magnitude,
                       topology().freedoms.size() + topology().actions.size() + friction,
                       variable_count());
}

WrenchOf<Dual> DualCase::friction_wrench(std::size_t i) const {
  return friction(i) * laws_[i].unit;
}

FrictionLawOf<Dual> DualCase::law_of(CouplingId id) const {
  const auto e = static_cast<std::size_t>(id.value);
  const auto found =
      std::ranges::find(derivatives_.frictions, id, &CouplingFrictionOf<Dual>::coupling);
  KINESTAT_EXPECTS(motion_ != nullptr && found != derivatives_.frictions.end());
  CouplingFrictionOf<Dual> friction = *found;
  for (Dual* number : {&friction.mu,
                       &friction.radius,
                       &friction.thrust_radius,
                       &friction.tau,
                       &friction.viscous}) {
    *number = placed(*number);
  }
  if (friction.length) {
    friction.length = placed(*friction.length);
  }
  if (friction.tau_of_speed) {
    for (auto& parameter : friction.tau_of_speed->parameters()) {
      parameter.second.value = placed(parameter.second.value);
    }
  }
  ConverterTurnsOf<Dual> turns;
  const Vec3Of<Dual> axis =
      unit_motion(static_cast<std::size_t>(topology().couplings[e].first_freedom)).angular;
  if (friction.converter) {
    ConverterLawOf<Dual> converter = *friction.converter;
    const auto place = [&](const Dual& number) { return placed(number); };
    converter.scale = placed(converter.scale);
    converter.capacity.change_numbers(place);
    if (converter.torque_ratio) {
      converter.torque_ratio->change_numbers(place);
    }
    const auto turning = [&](BodyId body) {
      const TwistOf<Dual> twist = body_twist(static_cast<std::size_t>(body.value)) -
                                  body_twist(static_cast<std::size_t>(converter.stator.value));
      return Dual(twist.angular.dot(axis));
    };
    turns = {.pump = turning(converter.pump), .turbine = turning(converter.turbine)};
    friction.converter = std::make_shared<const ConverterLawOf<Dual>>(std::move(converter));
  }
  const int freedom = topology().couplings[e].first_freedom;
  return make_friction_law(SlidingOf<Dual>{
      .topology = topology(),
      .friction = friction,
      .unit = unit_motion(static_cast<std::size_t>(freedom)),
      .twist = coupling_twist(e),
      .at = point(e),
      .unit_action = [&](int a) { return unit_action(static_cast<std::size_t>(a)); },
      .converter = turns});
}

TwistOf<Dual> DualCase::coupling_twist(std::size_t coupling) const {
  const CouplingTopology& edge = topology().couplings[coupling];
  TwistOf<Dual> sum;
  for (int i = edge.first_freedom; i < edge.first_freedom + edge.freedom_count; ++i) {
    const auto f = static_cast<std::size_t>(i);
    sum = sum + rate(f) * unit_motion(f);
  }
  return sum;
}

TwistOf<Dual> DualCase::along_tree(
    std::size_t body, const std::function<TwistOf<Dual>(std::size_t)>& of_coupling) const {
  TwistOf<Dual> sum;
  while (body != 0) {
    const Step& step = steps_[body];
    const CouplingTopology& edge = topology().couplings[static_cast<std::size_t>(step.coupling)];
    const TwistOf<Dual> twist = of_coupling(static_cast<std::size_t>(step.coupling));
    sum = step.forward ? sum + twist : sum - twist;
    body = static_cast<std::size_t>(step.forward ? edge.tail.value : edge.head.value);
  }
  return sum;
}

TwistOf<Dual> DualCase::body_twist(std::size_t body) const {
  return along_tree(body, [this](std::size_t e) { return coupling_twist(e); });
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
    sum = sum + *size * unit_action(a);
  }
  for (std::size_t i = 0; i < friction_count(); ++i) {
    if (laws_[i].coupling.value == static_cast<int>(coupling)) {
      sum = sum + friction_wrench(i);
    }
  }
  return sum;
}

WrenchOf<Dual> DualCase::load_wrench(std::size_t load) const {
  return placed(primaries().loads[load]);
}

Vec3Of<Dual> DualCase::point(std::size_t coupling) const {
  return placed(derivatives_.geometry.points[coupling]);
}

Vec3Of<Dual> DualCase::reference(std::size_t body) const {
  return placed(derivatives_.geometry.references[body]);
}

}  // namespace kinestat
