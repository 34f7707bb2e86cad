#include "studies/duty/slip_finder.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "network/bases.hpp"
#include "statics/action.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

namespace {

// Whether the friction of a coupling hangs on what presses, if it has any.
bool is_pressed(const Topology& topology, const CouplingFriction& friction) {
  const FrictionKind kind = kind_of(topology.coupling(friction.coupling).type).friction;
  return friction.mu != 0.0 || !friction.cables.empty() ||
         (kind == FrictionKind::thread && friction.radius != 0.0);
}

bool has_drag(const CouplingFriction& friction) {
  return friction.tau != 0.0 || friction.tau_of_speed || friction.viscous != 0.0;
}

const CouplingFriction& friction_of(const Mechanism& mechanism, CouplingId coupling) {
  return *std::ranges::find(mechanism.frictions, coupling, &CouplingFriction::coupling);
}

Vec3 turning_axis(const Mechanism& mechanism, CouplingId coupling) {
  const int freedom = mechanism.topology.coupling(coupling).first_freedom;
  return mechanism.geometry.motions[static_cast<std::size_t>(freedom)].angular;
}

// 1 along the freedom of a coupling, on its head.
Wrench unit_along(const Mechanism& mechanism, CouplingId coupling) {
  const int first = mechanism.topology.coupling(coupling).first_freedom;
  const auto freedom = static_cast<std::size_t>(first);
  const Twist& unit = mechanism.geometry.motions[freedom];
  const Vec3& at = mechanism.geometry.points[static_cast<std::size_t>(coupling.value)];
  return mechanism.topology.freedoms[freedom].is_rotation ? unit_couple<double>(unit.angular)
                                                          : unit_force<double>(unit.linear, at);
}

bool is_same_converter(const ConverterLaw& a, const ConverterLaw& b) {
  return a.pump == b.pump && a.turbine == b.turbine && a.stator == b.stator;
}

}  // namespace

bool SlipFinder::Sum::is_doubtful() const {
  return size > 0.0 && std::abs(value) <= slack + kDoubtfulSign * size;
}

SlipFinder::SlipFinder(const Mechanism& mechanism,
                       const Case& closed,
                       const ConverterSearch& search,
                       const CaseMotions& motions)
    : mechanism_(mechanism),
      motions_(motions),
      law_(*friction_of(mechanism, search.coupling).converter),
      scan_(law_),
      deciding_(search.action),
      axis_(turning_axis(mechanism, search.coupling)),
      known_(closed.motions),
      values_(closed.motions.size(), 0.0) {
  if (!motions.is_solved()) {
    return;
  }
  Case nothing = closed;
  for (Primary& action : nothing.actions) {
    action.value = 0.0;
  }
  const std::vector<BodyWrench> loads = wrenches_of(closed.loads);
  const std::optional<double> of_loads = share_of(nothing, loads);
  if (!of_loads) {
    return;
  }
  of_loads_ = *of_loads;
  for (Primary& action : nothing.actions) {
    action.value = 1.0;
    const std::optional<double> share = share_of(nothing, {});
    action.value = 0.0;
    if (!share) {
      return;
    }
    of_actions_.push_back(*share);
  }
  std::vector<double> slip(values_.size(), 0.0);
  slip.back() = 1.0;
  slope_ = motions_.turning(law_.pump, law_.stator, slip).dot(axis_);
  is_able_ = std::ranges::all_of(mechanism.frictions, [&](const CouplingFriction& friction) {
    return add_couple(friction, nothing);
  });
}

// Of the deciding action; empty where equilibrium leaves it open.
std::optional<double> SlipFinder::share_of(const Case& closed,
                                           std::span<const BodyWrench> loads) const {
  const CoordinateBasis basis = action_basis(mechanism_.geometry, mechanism_.static_order, loads);
  const StaticSolution solution = solve_action(mechanism_, basis, closed.actions, loads);
  return solution.status == SolveStatus::solved
             ? solution.magnitudes[static_cast<std::size_t>(deciding_)]
             : std::nullopt;
}

bool SlipFinder::add_couple(const CouplingFriction& friction, Case& nothing) {
  if (is_pressed(mechanism_.topology, friction)) {
    return false;
  }
  if (!friction.converter && !has_drag(friction)) {
    return true;
  }
  const CouplingTopology& coupling = mechanism_.topology.coupling(friction.coupling);
  const Wrench unit = unit_along(mechanism_, friction.coupling);
  const std::vector<BodyWrench> pair = {{.body = coupling.head, .wrench = unit},
                                        {.body = coupling.tail, .wrench = -1.0 * unit}};
  const std::optional<double> share = share_of(nothing, pair);
  if (!share) {
    return false;
  }
  Couple couple{
      .friction = &friction,
      .freedom = coupling.first_freedom,
      .axis = turning_axis(mechanism_, friction.coupling),
      .share = *share,
      .follows_ratio = friction.converter && is_same_converter(*friction.converter, law_)};
  if (couple.follows_ratio) {
    add_nodes(couple);
  }
  couples_.push_back(std::move(couple));
  return true;
}

void SlipFinder::add_nodes(Couple& couple) const {
  for (const double ratio : scan_.nodes()) {
    couple.at_nodes.push_back(couple.friction->converter->couple(1.0, ratio));
  }
}

// Turbine and pump differ by the slip. Empty where none gives that speed ratio.
std::optional<double> SlipFinder::slip_at(double ratio) const {
  const double slip = (ratio - 1.0) * first_ / (1.0 - (ratio - 1.0) * slope_);
  return std::isfinite(slip) ? std::optional(slip) : std::nullopt;
}

std::optional<SlipFinder::Sum> SlipFinder::miss_at(double ratio, std::optional<std::size_t> node) {
  const std::optional<double> slip = slip_at(ratio);
  if (!slip) {
    return std::nullopt;
  }
  values_.back() = *slip;
  const double pump = first_ + *slip * slope_;
  Sum miss = rest_;
  for (const Couple& couple : couples_) {
    const std::optional<Sum> one =
        couple.friction->converter ? flow_of(couple, ratio, node, pump) : drag_of(couple);
    if (!one) {
      return std::nullopt;
    }
    miss.value += couple.share * one->value;
    miss.size += std::abs(couple.share * one->value);
    miss.slack += std::abs(couple.share) * one->slack;
  }
  return miss;
}

// A converter's couple on its head; it grows with the square of the speed of its pump.
std::optional<SlipFinder::Sum> SlipFinder::flow_of(const Couple& couple,
                                                   double ratio,
                                                   std::optional<std::size_t> node,
                                                   double pump) const {
  const ConverterLaw& law = *couple.friction->converter;
  std::optional<double> flow;
  if (!couple.follows_ratio) {
    flow = law.couple(motions_.turning(law.pump, law.stator, values_).dot(couple.axis),
                      motions_.turning(law.turbine, law.stator, values_).dot(couple.axis));
  } else if (const auto unit = node ? couple.at_nodes[*node] : law.couple(1.0, ratio)) {
    flow = *unit * pump * std::abs(pump);
  }
  return flow ? std::optional(Sum{.value = *flow}) : std::nullopt;
}

// On its head, against the rate of the coupling.
std::optional<SlipFinder::Sum> SlipFinder::drag_of(const Couple& couple) {
  const CouplingFriction& friction = *couple.friction;
  const double rate = motions_.rate(couple.freedom, values_);
  const std::optional<double> tau = tau_at(friction, std::abs(rate));
  const bool has_tau = friction.tau != 0.0 || friction.tau_of_speed;
  Sum drag;
  if (has_tau && std::abs(rate) <= kDoubtfulSign * largest_) {
    if (!tau || !is_free_at_rest(mechanism_.topology, known_, friction)) {
      is_doubtful_ = true;
      return std::nullopt;
    }
    drag.slack = 2.0 * friction.planets * *tau;
  }
  if (rate == 0.0) {
    return drag;
  }
  if (!tau) {
    return std::nullopt;
  }
  drag.value = -friction.planets * (std::copysign(*tau, rate) + friction.viscous * rate);
  return drag;
}

SlipAnswer SlipFinder::find(std::span<const double> motions,
                            std::span<const double> actions,
                            double deciding) {
  std::ranges::copy(motions, values_.begin());
  values_.back() = 0.0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    known_[i].value = motions[i];
  }
  first_ = motions_.turning(law_.pump, law_.stator, values_).dot(axis_);
  largest_ = 0.0;
  for (const double motion : motions) {
    largest_ = std::max(largest_, std::abs(motion));
  }
  rest_ = {.value = of_loads_ - deciding, .size = std::abs(of_loads_) + std::abs(deciding)};
  for (std::size_t i = 0; i < actions.size(); ++i) {
    rest_.value += of_actions_[i] * actions[i];
    rest_.size += std::abs(of_actions_[i] * actions[i]);
  }
  is_doubtful_ = false;
  const auto at_node = [&](std::size_t node) -> std::optional<double> {
    const std::optional<Sum> miss = miss_at(scan_.nodes()[node], node);
    is_doubtful_ = is_doubtful_ || (miss && miss->is_doubtful());
    return miss ? std::optional(miss->value) : std::nullopt;
  };
  const FittingRatios found = scan_.run(at_node, [&](double ratio) -> std::optional<double> {
    const std::optional<Sum> miss = miss_at(ratio, std::nullopt);
    return miss ? std::optional(miss->value) : std::nullopt;
  });
  if (is_doubtful_ || !found.has_any) {
    return {};
  }
  return {.is_sure = true,
          .rate = found.ratios.size() == 1 ? slip_at(found.ratios.front()) : std::nullopt};
}

}  // namespace kinestat
