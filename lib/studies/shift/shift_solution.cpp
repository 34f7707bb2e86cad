#include "studies/shift/shift_solution.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "power/rate_ratio.hpp"
#include "studies/shift/shift_reason.hpp"

namespace kinestat {

namespace {

// "C1+B2"
std::string joined_names(const Topology& topology,
                         const ShiftPlan& plan,
                         const std::vector<int>& engaged) {
  std::string name;
  for (const int e : engaged) {
    const int actuator = plan.elements[static_cast<std::size_t>(e)].actuator;
    name += (name.empty() ? "" : "+") + topology.actuators[static_cast<std::size_t>(actuator)].name;
  }
  return name.empty() ? std::string(kNothingEngaged) : name;
}

// The next combination of `count` elements of the same size, in order; false after the last.
bool advance(std::vector<int>& engaged, int count) {
  const int size = static_cast<int>(engaged.size());
  for (int i = size - 1; i >= 0; --i) {
    int& element = engaged[static_cast<std::size_t>(i)];
    if (element < count - size + i) {
      std::iota(engaged.begin() + i, engaged.end(), element + 1);
      return true;
    }
  }
  return false;
}

class ShiftSolver {
 public:
  ShiftSolver(const Mechanism& mechanism,
              const CoordinateBasis& basis,
              const ShiftPlan& plan,
              const ShiftOptions& options)
      : topology_(mechanism.topology),
        plan_(plan),
        options_(options),
        network_(make_shift_network(mechanism, basis, plan)) {}

  ShiftSolution run() {
    solution_.net_freedom = network_.net_freedom();
    solution_.needed = network_.needed();
    solution_.following = network_.following(plan_);
    for (int more = 0; more <= solution_.following; ++more) {
      solution_.possibilities += combination_count(count(), network_.needed() + more);
    }
    for (const int size : sizes()) {
      solution_.asked += combination_count(count(), size);
    }
    if (plan_.combinations == ShiftCombinations::named) {
      solution_.asked += static_cast<double>(plan_.labels.size());
    }
    solution_.is_too_long = solution_.asked > kMostCombinations;
    if (!solution_.is_too_long) {
      enumerate();
      sort();
    }
    return std::move(solution_);
  }

 private:
  int count() const { return static_cast<int>(plan_.elements.size()); }

  std::vector<int> sizes() const {
    std::vector<int> sizes;
    if (plan_.combinations == ShiftCombinations::all) {
      for (int more = 0; more <= network_.following(plan_); ++more) {
        sizes.push_back(network_.needed() + more);
      }
    }
    if (options_.one_fewer && network_.needed() > 0) {
      sizes.push_back(network_.needed() - 1);
    }
    if (options_.one_more) {
      sizes.push_back(network_.needed() + network_.following(plan_) + 1);
    }
    return sizes;
  }

  void enumerate() {
    for (const int size : sizes()) {
      if (size > count()) {
        continue;
      }
      std::vector<int> engaged(static_cast<std::size_t>(size));
      std::iota(engaged.begin(), engaged.end(), 0);
      do {
        add(engaged);
      } while (advance(engaged, count()));
    }
    for (const ShiftLabel& label : plan_.labels) {
      if (std::ranges::find(solution_.states, label.engaged, &NamedShiftState::engaged) ==
          solution_.states.end()) {
        add(label.engaged);
      }
    }
  }

  void add(const std::vector<int>& engaged) {
    const auto label = std::ranges::find(plan_.labels, engaged, &ShiftLabel::engaged);
    const bool has_label = label != plan_.labels.end();
    NamedShiftState one{.name = has_label ? label->text : joined_names(topology_, plan_, engaged),
                        .engaged = engaged,
                        .where = has_label ? label->where : plan_.where,
                        .state = solve_shift_state(network_, plan_, engaged),
                        .reason = {}};
    one.reason = reason_of(topology_, network_, plan_, engaged, one.state);
    solution_.states.push_back(std::move(one));
  }

  // Gears first, by their ratios.
  void sort() {
    std::vector<TableGear> gears;
    std::vector<NamedShiftState> others;
    for (std::size_t s = 0; s < solution_.states.size(); ++s) {
      const NamedShiftState& one = solution_.states[s];
      if (one.state.kind != ShiftClass::gear) {
        others.push_back(one);
        continue;
      }
      const std::optional<double> ratio =
          share_of(reference_rate(plan_, one.state), one.state.outputs.front());
      gears.push_back({.state = static_cast<int>(s),
                       .ratio = ratio == 0.0 ? std::nullopt : ratio,
                       .engaged = one.holding(),
                       .slips = one.state.slips});
    }
    const double forward = plan_.forward.value_or(find_forward_sign(gears));
    sort_gears(gears, forward);
    std::vector<NamedShiftState> states;
    for (TableGear& gear : gears) {
      states.push_back(solution_.states[static_cast<std::size_t>(gear.state)]);
      gear.state = static_cast<int>(states.size()) - 1;
    }
    states.insert(states.end(), others.begin(), others.end());
    solution_.states = std::move(states);
    solution_.table = make_shift_table(gears, forward);
  }

  const Topology& topology_;
  const ShiftPlan& plan_;
  const ShiftOptions& options_;
  ShiftNetwork network_;
  ShiftSolution solution_;
};

}  // namespace

std::vector<int> NamedShiftState::holding() const {
  std::vector<int> elements;
  std::ranges::set_difference(engaged, state.overrunning, std::back_inserter(elements));
  return elements;
}

std::optional<double> reference_rate(const ShiftPlan& plan, const ShiftState& state) {
  if (!plan.is_hybrid()) {
    return common_rate(state.inputs);
  }
  return plan.has_shares(state.moving) ? std::nullopt : std::optional(state.inputs.front());
}

double combination_count(int n, int k) {
  if (k > n || k < 0) {
    return 0.0;
  }
  double count = 1.0;
  for (int i = 1; i <= std::min(k, n - k); ++i) {
    count = count * (n - std::min(k, n - k) + i) / i;
  }
  return count;
}

ShiftSolution find_shift_solution(const Mechanism& mechanism,
                                  const CoordinateBasis& basis,
                                  const ShiftPlan& plan,
                                  const ShiftOptions& options) {
  return ShiftSolver(mechanism, basis, plan, options).run();
}

}  // namespace kinestat
