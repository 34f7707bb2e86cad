#include "statics/internal/friction_system.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/tolerance.hpp"
#include "statics/coupling_wrenches.hpp"
#include "statics/internal/tied_tensions.hpp"

namespace kinestat {

namespace {

std::vector<int> indices_of(std::span<const Primary> primaries) {
  std::vector<int> indices;
  for (const Primary& primary : primaries) {
    indices.push_back(primary.index);
  }
  return indices;
}

std::vector<double> values_of(std::span<const Primary> primaries) {
  std::vector<double> values;
  for (const Primary& primary : primaries) {
    values.push_back(primary.value);
  }
  return values;
}

// What a coupling bears without its friction.
Vec6 passive_wrench(const Mechanism& mechanism, CouplingId id, const VecX& magnitudes) {
  const CouplingTopology& coupling = mechanism.topology.coupling(id);
  Vec6 sum = Vec6::Zero();
  for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
    sum += magnitudes[a] * mechanism.geometry.actions[static_cast<std::size_t>(a)].coordinates();
  }
  return sum;
}

// What presses, or what is ignored: the wrench of a coupling with those beside it.
Vec6 pressing_wrench(const Mechanism& mechanism,
                     CouplingId of,
                     const std::vector<CountedCoupling>& beside,
                     const VecX& magnitudes) {
  Vec6 sum = passive_wrench(mechanism, of, magnitudes);
  for (const CountedCoupling& other : beside) {
    sum += other.sign * passive_wrench(mechanism, other.coupling, magnitudes);
  }
  return sum;
}

}  // namespace

std::vector<IgnoredReaction> ignored_reactions(const Mechanism& mechanism,
                                               const FrictionLaw& law,
                                               std::span<const std::optional<double>> magnitudes) {
  std::vector<IgnoredReaction> found;
  if (law.ignored.empty()) {
    return found;
  }
  const double length = mechanism.geometry.length;
  VecX known(mechanism.topology.action_count());
  for (Eigen::Index a = 0; a < known.size(); ++a) {
    known[a] = magnitudes[static_cast<std::size_t>(a)].value_or(std::nan(""));
  }
  const Vec6 wrench = passive_wrench(mechanism, law.coupling, known);
  const double force = wrench.tail<3>().norm() + wrench.head<3>().norm() / length;
  for (const IgnoredPart& one : law.ignored) {
    const double size =
        (one.part * pressing_wrench(mechanism, law.coupling, one.beside, known)).norm();
    const bool is_couple = one.reaction != Reaction::axial;
    if (size > kNoReaction * force * (is_couple ? length : 1.0)) {
      found.push_back({.coupling = law.coupling, .reaction = one.reaction, .size = size});
    }
  }
  return found;
}

FrictionSystem::FrictionSystem(const Mechanism& mechanism,
                               const CoordinateBasis& basis,
                               std::span<const Primary> primaries,
                               std::span<const BodyWrench> loads,
                               std::span<const FrictionLaw> laws,
                               const std::vector<TiedTension>& ties,
                               std::span<const std::vector<BodyWrench>> along)
    : mechanism_(mechanism),
      primaries_(primaries),
      loads_(loads),
      laws_(laws),
      ties_(ties),
      along_(along),
      equilibrium_(mechanism, basis, indices_of(primaries), ties_),
      frictionless_(equilibrium_.solve(values_of(primaries), loads).magnitudes),
      responses_(laws.size()),
      is_open_(laws.size(), false) {
  for (const FrictionLaw& law : laws) {
    slopes_.emplace_back(law.parts.size(), std::vector<std::optional<Vec3>>(laws.size()));
  }
}

void FrictionSystem::set_primaries(std::span<const double> values) {
  std::vector<double> units(primaries_.size(), 0.0);
  if (of_loads_.size() == 0) {
    of_loads_ = equilibrium_.solve(units, loads_).magnitudes;
    for (double& unit : units) {
      unit = 1.0;
      of_primaries_.emplace_back(equilibrium_.solve(units, {}).magnitudes);
      unit = 0.0;
    }
  }
  frictionless_ = of_loads_;
  for (std::size_t i = 0; i < values.size(); ++i) {
    frictionless_ += values[i] * of_primaries_[i];
  }
}

Vec3 FrictionSystem::slope(std::size_t law, std::size_t part, std::size_t friction) const {
  std::optional<Vec3>& known = slopes_[law][part][friction];
  if (!known) {
    const PressingPart& pressing = laws_[law].parts[part];
    known = pressing_force(pressing, laws_[law], response(friction));
  }
  return *known;
}

const VecX& FrictionSystem::response(std::size_t i) const {
  if (!responses_[i]) {
    const std::vector<double> nothing(primaries_.size(), 0.0);
    std::vector<BodyWrench> loads = pair_of(laws_[i], 1.0);
    if (!along_.empty()) {
      std::ranges::copy(along_[i], std::back_inserter(loads));
    }
    responses_[i] = equilibrium_.solve(nothing, loads).magnitudes;
  }
  return *responses_[i];
}

// The friction on both bodies.
std::vector<BodyWrench> FrictionSystem::pair_of(const FrictionLaw& law, double magnitude) const {
  const CouplingTopology& coupling = mechanism_.topology.coupling(law.coupling);
  const BodyPair bodies =
      law.between.value_or(BodyPair{.tail = coupling.tail, .head = coupling.head});
  return {{.body = bodies.head, .wrench = magnitude * law.unit},
          {.body = bodies.tail, .wrench = -magnitude * law.unit}};
}

Vec3 FrictionSystem::pressing_force(const PressingPart& part,
                                    const FrictionLaw& law,
                                    const VecX& magnitudes) const {
  return part.part *
         pressing_wrench(mechanism_, part.of.value_or(law.coupling), part.beside, magnitudes);
}

bool FrictionSystem::needs_open_action(const FrictionLaw& law) const {
  return std::ranges::any_of(open_actions_, [&](int a) {
    const CouplingId owner = mechanism_.topology.actions[static_cast<std::size_t>(a)].coupling;
    const Vec6 screw = mechanism_.geometry.actions[static_cast<std::size_t>(a)].coordinates();
    return std::ranges::any_of(law.parts, [&](const PressingPart& part) {
      const bool presses =
          owner == part.of.value_or(law.coupling) ||
          std::ranges::find(part.beside, owner, &CountedCoupling::coupling) != part.beside.end();
      return presses &&
             (part.part * screw).norm() > kCancellation * screw.norm() * part.part.norm();
    });
  });
}

void FrictionSystem::find_open(std::vector<int> undetermined) {
  open_actions_ = std::move(undetermined);
  for (bool goes_on = !open_actions_.empty(); goes_on;) {
    goes_on = false;
    for (std::size_t i = 0; i < laws_.size(); ++i) {
      if (is_open_[i] || !needs_open_action(laws_[i])) {
        continue;
      }
      is_open_[i] = true;
      goes_on = true;
      const double largest = response(i).cwiseAbs().maxCoeff();
      for (int a = 0; a < response(i).size(); ++a) {
        if (std::abs(response(i)[a]) > kCancellation * largest) {
          open_actions_.push_back(a);
        }
      }
      std::ranges::sort(open_actions_);
      open_actions_.erase(std::unique(open_actions_.begin(), open_actions_.end()),
                          open_actions_.end());
    }
  }
}

Vec3 FrictionSystem::pressing_of(std::size_t law, std::size_t part, const VecX& actions) const {
  const PressingPart& pressing = laws_[law].parts[part];
  return pressing_force(pressing, laws_[law], actions);
}

FrictionFunction FrictionSystem::function_of(std::size_t i,
                                             const std::vector<std::size_t>& chosen) const {
  FrictionFunction function{.constant = laws_[i].constant, .forces = {}};
  for (std::size_t p = 0; p < laws_[i].parts.size(); ++p) {
    const PressingPart& part = laws_[i].parts[p];
    PressingForce force;
    force.part = &part;
    force.constant = pressing_force(part, laws_[i], frictionless_);
    force.slopes.resize(3, static_cast<Eigen::Index>(chosen.size()));
    for (std::size_t j = 0; j < chosen.size(); ++j) {
      force.slopes.col(static_cast<Eigen::Index>(j)) = slope(i, p, chosen[j]);
    }
    function.forces.push_back(std::move(force));
  }
  return function;
}

VecX FrictionSystem::actions_with(const ChosenFrictions& frictions) const {
  VecX actions = frictionless_;
  for (std::size_t i = 0; i < frictions.laws.size(); ++i) {
    actions += frictions.magnitudes[static_cast<Eigen::Index>(i)] * response(frictions.laws[i]);
  }
  return actions;
}

void FrictionSystem::leave_open(StaticSolution& solution) const {
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const CouplingId coupling = laws_[i].coupling;
    if (is_open_[i] && std::ranges::count(solution.open_friction, coupling) == 0) {
      solution.open_friction.push_back(coupling);
    }
  }
  if (solution.open_friction.empty()) {
    return;
  }
  solution.check.undetermined = open_actions_;
  for (const int a : open_actions_) {
    solution.magnitudes[static_cast<std::size_t>(a)].reset();
  }
  make_wrenches(mechanism_, solution);
}

void FrictionSystem::add_friction(const ChosenFrictions& frictions,
                                  StaticSolution& solution) const {
  for (std::size_t i = 0; i < frictions.laws.size(); ++i) {
    const FrictionLaw& law = laws_[frictions.laws[i]];
    const double magnitude = frictions.magnitudes[static_cast<Eigen::Index>(i)];
    solution.friction.push_back({.coupling = law.coupling,
                                 .between = law.between,
                                 .magnitude = magnitude,
                                 .is_couple = law.is_couple,
                                 .wrench = magnitude * law.unit});
  }
  if (!solution.wrenches.empty()) {
    make_wrenches(mechanism_, solution);
  }
}

void FrictionSystem::add_ignored(StaticSolution& solution) const {
  for (const FrictionLaw& law : laws_) {
    std::ranges::copy(ignored_reactions(mechanism_, law, solution.magnitudes),
                      std::back_inserter(solution.ignored));
  }
}

StaticSolution FrictionSystem::solution_with(const ChosenFrictions& frictions) const {
  std::vector<BodyWrench> all(loads_.begin(), loads_.end());
  for (std::size_t i = 0; i < frictions.laws.size(); ++i) {
    std::ranges::copy(
        pair_of(laws_[frictions.laws[i]], frictions.magnitudes[static_cast<Eigen::Index>(i)]),
        std::back_inserter(all));
  }
  StaticSolution solution =
      solve_action(mechanism_, equilibrium_.basis(), primaries_, all, {}, ties_);
  if (solution.unconstrained) {
    std::erase_if(solution.unconstrained->loads,
                  [&](int load) { return load >= std::ssize(loads_); });
  }
  if (!solution.magnitudes.empty()) {
    leave_open(solution);
    add_friction(frictions, solution);
    add_ignored(solution);
  }
  return solution;
}

}  // namespace kinestat
