#include "statics/internal/friction_hold.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/tolerance.hpp"
#include "statics/action.hpp"
#include "statics/internal/friction_function.hpp"
#include "statics/internal/friction_system.hpp"
#include "statics/one_sided_action.hpp"

namespace kinestat {

namespace {

// Where the search starts, in multiples of the known action: there the open one alone presses.
constexpr double kFar = 1e6;

// The action that is to be known instead of the primary which nothing but friction holds: one of
// an actuator, if there is any.
std::optional<int> instead_of_primary(const Topology& topology, const StaticSolution& solution) {
  const std::vector<int>& open = solution.check.undetermined;
  for (const int a : topology.driving_actions()) {
    if (std::ranges::find(open, a) != open.end()) {
      return a;
    }
  }
  return open.empty() ? std::nullopt : std::optional(open.front());
}

// The case with the open action known, in place of the one that friction holds.
struct Exchange {
  int held = 0;        // index of the action
  double known = 0.0;  // its magnitude [N·m or N]
  std::vector<Primary> primaries;
  std::size_t place = 0;  // of the open action among them
};

std::optional<Exchange> exchange_for(const Topology& topology,
                                     std::span<const Primary> primaries,
                                     const StaticSolution& frictionless) {
  const std::vector<Dependence>& relations = frictionless.check.dependences;
  const std::optional<int> open = instead_of_primary(topology, frictionless);
  if (relations.size() != 1 || relations.front().terms.empty() || !open) {
    return std::nullopt;
  }
  Exchange result{.held = relations.front().terms.front().index,
                  .primaries = {primaries.begin(), primaries.end()}};
  const auto at = std::ranges::find(result.primaries, result.held, &Primary::index);
  if (at == result.primaries.end()) {
    return std::nullopt;
  }
  result.known = at->value;
  result.place = static_cast<std::size_t>(at - result.primaries.begin());
  at->index = *open;
  return result;
}

std::vector<Primary> with_open(const Exchange& exchange, double value) {
  std::vector<Primary> primaries = exchange.primaries;
  primaries[exchange.place].value = value;
  return primaries;
}

// The frictions and the open action together: the last unknown is how much of the open action acts.
class HeldSystem {
 public:
  HeldSystem(const Mechanism& mechanism,
             const CoordinateBasis& basis,
             const FrictionLoads& given,
             const Exchange& exchange)
      : none_(with_open(exchange, 0.0)),
        one_(with_open(exchange, 1.0)),
        without_(mechanism, basis, none_, given.loads, given.laws),
        with_one_(mechanism, basis, one_, given.loads, given.laws),
        by_one_(with_one_.frictionless() - without_.frictionless()),
        all_(given.laws.size()),
        count_(std::ssize(given.laws)) {
    std::iota(all_.begin(), all_.end(), std::size_t{0});
    condition_ = {.constant = without_.frictionless()[exchange.held] - exchange.known,
                  .slopes = VecX(count_ + 1)};
    for (const std::size_t i : all_) {
      functions_.push_back(function_of(i));
      condition_.slopes[static_cast<Eigen::Index>(i)] = without_.response(i)[exchange.held];
    }
    condition_.slopes[count_] = by_one_[exchange.held];
    size_ = std::abs(exchange.known) / mechanism.geometry.length + std::abs(exchange.known) +
            without_.frictionless().cwiseAbs().maxCoeff();
  }

  HeldSystem(const HeldSystem&) = delete;  // its parts look at each other
  HeldSystem& operator=(const HeldSystem&) = delete;

  // All actions of the equilibrium in which the open action is of that sense.
  std::optional<VecX> actions_on(double side) const {
    VecX start = VecX::Zero(count_ + 1);
    start[count_] = side * kFar * size_;
    const std::optional<VecX> f = solve_friction(functions_, condition_, start);
    if (!f) {
      return std::nullopt;
    }
    return without_.actions_with({.laws = all_, .magnitudes = f->head(count_)}) +
           (*f)[count_] * by_one_;
  }

 private:
  FrictionFunction function_of(std::size_t i) const {
    FrictionFunction function = without_.function_of(i, all_);
    const FrictionFunction moved = with_one_.function_of(i, all_);
    for (std::size_t p = 0; p < function.forces.size(); ++p) {
      PressingForce& force = function.forces[p];
      force.slopes.conservativeResize(Eigen::NoChange, count_ + 1);
      force.slopes.col(count_) = moved.forces[p].constant - force.constant;
    }
    return function;
  }

  std::vector<Primary> none_;  // the systems look at them
  std::vector<Primary> one_;
  FrictionSystem without_;
  FrictionSystem with_one_;
  VecX by_one_;  // actions for 1 of the open one
  std::vector<std::size_t> all_;
  Eigen::Index count_ = 0;
  std::vector<FrictionFunction> functions_;
  FrictionCondition condition_;
  double size_ = 0.0;
};

}  // namespace

std::vector<VecX> find_held_by_friction(const Mechanism& mechanism,
                                        const CoordinateBasis& basis,
                                        const FrictionLoads& given,
                                        const StaticSolution& frictionless) {
  const std::optional<Exchange> exchange =
      exchange_for(mechanism.topology, given.primaries, frictionless);
  if (!exchange || solve_action(mechanism, basis, exchange->primaries, given.loads).status !=
                       SolveStatus::solved) {
    return {};
  }
  const HeldSystem system(mechanism, basis, given, *exchange);
  std::vector<VecX> found;
  for (const double side : {1.0, -1.0}) {
    const std::optional<VecX> actions = system.actions_on(side);
    const bool is_new = actions && (found.empty() || (*actions - found.front()).norm() >
                                                         kConsistency * actions->norm());
    if (is_new && is_one_sided(*actions, mechanism.topology)) {
      found.push_back(*actions);
    }
  }
  return found;
}

}  // namespace kinestat
