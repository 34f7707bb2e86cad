#include "statics/friction.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "math/dense_solve.hpp"
#include "statics/action.hpp"
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

// The friction on both bodies of its coupling.
std::vector<BodyWrench> pair_of(const Mechanism& mechanism,
                                const FrictionLaw& law,
                                double magnitude) {
  const CouplingTopology& coupling = mechanism.topology.coupling(law.coupling);
  return {{.body = coupling.head, .wrench = magnitude * law.unit},
          {.body = coupling.tail, .wrench = -magnitude * law.unit}};
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
  const CouplingTopology& coupling = mechanism.topology.coupling(law.coupling);
  return std::ranges::any_of(undetermined, [&](int a) {
    const bool is_own =
        a >= coupling.first_action && a < coupling.first_action + coupling.action_count;
    const Vec6 screw = mechanism.geometry.actions[static_cast<std::size_t>(a)].coordinates();
    return is_own && std::ranges::any_of(law.parts, [&](const PressingPart& part) {
             return (part.part * screw).norm() > kCancellation * screw.norm() * part.part.norm();
           });
  });
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
      force.constant = part.part * coupling_wrench(mechanism, law.coupling, frictionless);
      force.slopes.resize(3, static_cast<Eigen::Index>(laws.size()));
      for (std::size_t j = 0; j < laws.size(); ++j) {
        force.slopes.col(static_cast<Eigen::Index>(j)) =
            part.part * coupling_wrench(mechanism, law.coupling, responses[j]);
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
                                 .magnitude = magnitude,
                                 .is_couple = laws[i].is_couple,
                                 .wrench = magnitude * laws[i].unit});
    if (e < solution.wrenches.size() && solution.wrenches[e]) {
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
  const bool is_open = std::ranges::any_of(laws, [&](const FrictionLaw& law) {
    return needs_open_action(mechanism, law, frictionless.check.undetermined);
  });
  if (laws.empty() || !has_answer || is_open) {
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
  const std::vector<FrictionFunction> functions =
      find_functions(mechanism, laws, equilibrium.solve(known, loads).magnitudes, responses);
  const std::optional<VecX> f = Continuation(functions).run();
  if (!f) {
    frictionless.status = SolveStatus::locked;
    frictionless.magnitudes.clear();
    frictionless.wrenches.clear();
    return frictionless;
  }
  std::vector<BodyWrench> all(loads.begin(), loads.end());
  for (std::size_t i = 0; i < laws.size(); ++i) {
    for (BodyWrench& one : pair_of(mechanism, laws[i], (*f)[static_cast<Eigen::Index>(i)])) {
      all.push_back(one);
    }
  }
  StaticSolution solution = solve_action(mechanism, basis, primaries, all);
  if (!solution.wrenches.empty()) {
    add_friction(laws, *f, solution);
  }
  return solution;
}

}  // namespace kinestat
