#include "statics/friction.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/tolerance.hpp"
#include "math/dense_solve.hpp"
#include "statics/action.hpp"
#include "statics/coupling_wrenches.hpp"
#include "statics/equilibrium.hpp"

namespace kinestat {

namespace {

// |constant + Σ f_j slopes_j| times a weight.
struct PressingForce {
  Vec3 constant = Vec3::Zero();
  Eigen::Matrix<double, 3, Eigen::Dynamic> slopes;
  const PressingPart* part = nullptr;
};

// The friction of a coupling as a function of all frictions.
struct FrictionFunction {
  double constant = 0.0;
  std::vector<PressingForce> forces;
};

// The magnitude, with its gradient.
struct Evaluated {
  double value = 0.0;
  VecX gradient;
};

Evaluated evaluate(const FrictionFunction& function, const VecX& f) {
  Evaluated result{.value = function.constant, .gradient = VecX::Zero(f.size())};
  for (const PressingForce& force : function.forces) {
    const Vec3 v = force.constant + force.slopes * f;
    const double size = v.norm();
    const bool is_negative = force.part->is_signed && v.x() < 0.0;
    const double weight = is_negative ? force.part->weight_if_negative : force.part->weight;
    if (size > 0.0) {
      result.value += weight * size;
      result.gradient += (weight / size) * (force.slopes.transpose() * v);
    }
  }
  return result;
}

// Where f = share · functions(f) is solved, for a growing share of the friction.
class Continuation {
 public:
  explicit Continuation(const std::vector<FrictionFunction>& functions) : functions_(functions) {
    for (const FrictionFunction& function : functions) {
      size_ += std::abs(evaluate(function, VecX::Zero(count())).value);
    }
  }

  // Empty if the friction grows beyond all bounds on the way.
  std::optional<VecX> run() const {
    VecX f = VecX::Zero(count());
    double share = 0.0;
    double step = 1.0;
    while (share < 1.0) {
      const double next = std::min(1.0, share + step);
      const std::optional<VecX> found = newton(f, next);
      if (found && is_near(*found, f, next - share)) {
        f = *found;
        share = next;
        step *= 2.0;
      } else {
        step /= 2.0;
      }
      if (step < kLeastFrictionStep || f.cwiseAbs().sum() > kUnboundedFriction * size_) {
        return std::nullopt;
      }
    }
    return f;
  }

 private:
  Eigen::Index count() const { return static_cast<Eigen::Index>(functions_.size()); }

  // A branch that is followed changes little in a small step; another one is a jump away.
  bool is_near(const VecX& found, const VecX& before, double step) const {
    const double jump = (found - before).cwiseAbs().sum();
    return jump <= 4.0 * step * (size_ + before.cwiseAbs().sum()) + 0.5 * before.cwiseAbs().sum();
  }

  std::optional<VecX> newton(VecX f, double share) const {
    constexpr int kMostSteps = 40;
    for (int i = 0; i < kMostSteps; ++i) {
      VecX difference = f;
      MatX jacobian = MatX::Identity(count(), count());
      for (Eigen::Index r = 0; r < count(); ++r) {
        const Evaluated one = evaluate(functions_[static_cast<std::size_t>(r)], f);
        difference[r] -= share * one.value;
        jacobian.row(r) -= share * one.gradient.transpose();
      }
      const std::optional<VecX> correction = solve_dense(jacobian, difference);
      if (!correction) {
        return std::nullopt;
      }
      f -= *correction;
      if (correction->cwiseAbs().sum() <= kCancellation * (f.cwiseAbs().sum() + size_)) {
        return (f.array() >= -kReportZero * size_).all() ? std::optional(f) : std::nullopt;
      }
    }
    return std::nullopt;
  }

  const std::vector<FrictionFunction>& functions_;
  double size_ = 0.0;
};

// The friction on both bodies.
std::vector<BodyWrench> pair_of(const Mechanism& mechanism,
                                const FrictionLaw& law,
                                double magnitude) {
  const CouplingTopology& coupling = mechanism.topology.coupling(law.coupling);
  const BodyPair bodies =
      law.between.value_or(BodyPair{.tail = coupling.tail, .head = coupling.head});
  return {{.body = bodies.head, .wrench = magnitude * law.unit},
          {.body = bodies.tail, .wrench = -magnitude * law.unit}};
}

Vec6 coupling_wrench(const Mechanism& mechanism, CouplingId id, const VecX& magnitudes) {
  const CouplingTopology& coupling = mechanism.topology.coupling(id);
  Vec6 sum = Vec6::Zero();
  for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
    sum += magnitudes[a] * mechanism.geometry.actions[static_cast<std::size_t>(a)].coordinates();
  }
  return sum;
}

// Whether a law presses with an action that equilibrium leaves open.
bool needs_open_action(const Mechanism& mechanism,
                       const FrictionLaw& law,
                       const std::vector<int>& undetermined) {
  return std::ranges::any_of(undetermined, [&](int a) {
    const CouplingId owner = mechanism.topology.actions[static_cast<std::size_t>(a)].coupling;
    const Vec6 screw = mechanism.geometry.actions[static_cast<std::size_t>(a)].coordinates();
    return std::ranges::any_of(law.parts, [&](const PressingPart& part) {
      return owner == part.of.value_or(law.coupling) &&
             (part.part * screw).norm() > kCancellation * screw.norm() * part.part.norm();
    });
  });
}

// Which laws cannot be evaluated, and which actions cannot because of them.
struct OpenFriction {
  std::vector<bool> is_open;  ///< of each law
  std::vector<int> actions;   ///< ascending; those that equilibrium leaves open among them
};

// A law that needs an open action opens all actions that its friction moves.
OpenFriction find_open_friction(const Mechanism& mechanism,
                                std::span<const FrictionLaw> laws,
                                const std::vector<VecX>& responses,
                                std::vector<int> undetermined) {
  OpenFriction open{.is_open = std::vector<bool>(laws.size(), false),
                    .actions = std::move(undetermined)};
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (std::size_t i = 0; i < laws.size(); ++i) {
      if (open.is_open[i] || !needs_open_action(mechanism, laws[i], open.actions)) {
        continue;
      }
      open.is_open[i] = true;
      goes_on = true;
      const double largest = responses[i].cwiseAbs().maxCoeff();
      for (int a = 0; a < responses[i].size(); ++a) {
        if (std::abs(responses[i][a]) > kCancellation * largest) {
          open.actions.push_back(a);
        }
      }
      std::ranges::sort(open.actions);
      open.actions.erase(std::unique(open.actions.begin(), open.actions.end()), open.actions.end());
    }
  }
  return open;
}

void leave_open(const Mechanism& mechanism,
                std::span<const FrictionLaw> laws,
                const OpenFriction& open,
                StaticSolution& solution) {
  for (std::size_t i = 0; i < laws.size(); ++i) {
    if (open.is_open[i]) {
      solution.open_friction.push_back(laws[i].coupling);
    }
  }
  if (solution.open_friction.empty()) {
    return;
  }
  solution.check.undetermined = open.actions;
  for (const int a : open.actions) {
    solution.magnitudes[static_cast<std::size_t>(a)].reset();
  }
  solution.wrenches = coupling_wrenches(mechanism, solution);
}

// Reactions that press but do not rub, where all actions of their coupling are known.
std::vector<IgnoredReaction> find_ignored(const Mechanism& mechanism,
                                          std::span<const FrictionLaw> laws,
                                          const StaticSolution& solution) {
  std::vector<IgnoredReaction> list;
  const double length = mechanism.geometry.length;
  VecX magnitudes(mechanism.topology.action_count());
  for (Eigen::Index a = 0; a < magnitudes.size(); ++a) {
    magnitudes[a] = solution.magnitudes[static_cast<std::size_t>(a)].value_or(std::nan(""));
  }
  for (const FrictionLaw& law : laws) {
    const Vec6 wrench = coupling_wrench(mechanism, law.coupling, magnitudes);
    const double force = wrench.tail<3>().norm() + wrench.head<3>().norm() / length;
    for (const IgnoredPart& one : law.ignored) {
      const double size = (one.part * wrench).norm();
      const bool is_couple = one.reaction != Reaction::axial;
      if (size > kNoReaction * force * (is_couple ? length : 1.0)) {
        list.push_back({.coupling = law.coupling, .reaction = one.reaction, .size = size});
      }
    }
  }
  return list;
}

std::vector<FrictionFunction> find_functions(const Mechanism& mechanism,
                                             std::span<const FrictionLaw> laws,
                                             const VecX& frictionless,
                                             const std::vector<VecX>& responses) {
  std::vector<FrictionFunction> functions;
  for (const FrictionLaw& law : laws) {
    FrictionFunction function{.constant = law.constant, .forces = {}};
    for (const PressingPart& part : law.parts) {
      PressingForce force;
      force.part = &part;
      const CouplingId pressed = part.of.value_or(law.coupling);
      force.constant = part.part * coupling_wrench(mechanism, pressed, frictionless);
      force.slopes.resize(3, static_cast<Eigen::Index>(laws.size()));
      for (std::size_t j = 0; j < laws.size(); ++j) {
        force.slopes.col(static_cast<Eigen::Index>(j)) =
            part.part * coupling_wrench(mechanism, pressed, responses[j]);
      }
      function.forces.push_back(std::move(force));
    }
    functions.push_back(std::move(function));
  }
  return functions;
}

void add_friction(std::span<const FrictionLaw> laws, const VecX& f, StaticSolution& solution) {
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const double magnitude = f[static_cast<Eigen::Index>(i)];
    const auto e = static_cast<std::size_t>(laws[i].coupling.value);
    solution.friction.push_back({.coupling = laws[i].coupling,
                                 .between = laws[i].between,
                                 .magnitude = magnitude,
                                 .is_couple = laws[i].is_couple,
                                 .wrench = magnitude * laws[i].unit});
    if (!laws[i].between && e < solution.wrenches.size() && solution.wrenches[e]) {
      solution.wrenches[e] = *solution.wrenches[e] + solution.friction.back().wrench;
    }
  }
}

}  // namespace

StaticSolution solve_with_friction(const Mechanism& mechanism,
                                   const CoordinateBasis& basis,
                                   std::span<const Primary> primaries,
                                   std::span<const BodyWrench> loads,
                                   std::span<const FrictionLaw> laws) {
  StaticSolution frictionless = solve_action(mechanism, basis, primaries, loads);
  const bool has_answer = frictionless.status == SolveStatus::solved ||
                          frictionless.status == SolveStatus::underdetermined;
  if (laws.empty() || !has_answer) {
    return frictionless;
  }
  std::vector<int> indices;
  std::vector<double> known;
  for (const Primary& primary : primaries) {
    indices.push_back(primary.index);
    known.push_back(primary.value);
  }
  const Equilibrium equilibrium(mechanism, basis, std::move(indices));
  const std::vector<double> nothing(known.size(), 0.0);
  std::vector<VecX> responses;
  for (const FrictionLaw& law : laws) {
    responses.push_back(equilibrium.solve(nothing, pair_of(mechanism, law, 1.0)).magnitudes);
  }
  const OpenFriction open =
      find_open_friction(mechanism, laws, responses, frictionless.check.undetermined);
  std::vector<FrictionLaw> closed;
  std::vector<VecX> closed_responses;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    if (!open.is_open[i]) {
      closed.push_back(laws[i]);
      closed_responses.push_back(responses[i]);
    }
  }
  const std::vector<FrictionFunction> functions = find_functions(
      mechanism, closed, equilibrium.solve(known, loads).magnitudes, closed_responses);
  const std::optional<VecX> f = Continuation(functions).run();
  if (!f) {
    frictionless.status = SolveStatus::locked;
    frictionless.magnitudes.clear();
    frictionless.wrenches.clear();
    return frictionless;
  }
  std::vector<BodyWrench> all(loads.begin(), loads.end());
  for (std::size_t i = 0; i < closed.size(); ++i) {
    std::ranges::copy(pair_of(mechanism, closed[i], (*f)[static_cast<Eigen::Index>(i)]),
                      std::back_inserter(all));
  }
  StaticSolution solution = solve_action(mechanism, basis, primaries, all);
  if (solution.unheld) {
    std::erase_if(solution.unheld->loads, [&](int load) { return load >= std::ssize(loads); });
  }
  if (!solution.magnitudes.empty()) {
    leave_open(mechanism, laws, open, solution);
    add_friction(closed, *f, solution);
    solution.ignored = find_ignored(mechanism, laws, solution);
  }
  return solution;
}

}  // namespace kinestat
