#include "studies/sweep/state_rules.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "expression/evaluate.hpp"
#include "mechanism/bind/judged_numbers.hpp"

namespace kinestat {

namespace {

// Of each parameter, on which axes it depends.
std::vector<std::set<std::size_t>> axes_of_parameters(const SweepPlan& plan) {
  std::vector<std::set<std::size_t>> axes(plan.slots().values.size());
  for (std::size_t a = 0; a < plan.axes().size(); ++a) {
    axes[static_cast<std::size_t>(plan.axes()[a].parameter())].insert(a);
  }
  for (const DependentParameter& one : plan.dependents()) {
    std::set<std::size_t>& those = axes[static_cast<std::size_t>(one.parameter)];
    for (const int slot : one.value.slots()) {
      those.insert(axes[static_cast<std::size_t>(slot)].begin(),
                   axes[static_cast<std::size_t>(slot)].end());
    }
  }
  return axes;
}

}  // namespace

StateRules::StateRules(const SweepPlan& plan, const MechanismDescription& description)
    : units_(description.units) {
  const std::vector<std::set<std::size_t>> axes = axes_of_parameters(plan);
  const auto slot_of = [&](const std::string& name) {
    const auto at = std::ranges::find(
        description.parameters, name, [](const auto& parameter) { return parameter.name.text; });
    return at == description.parameters.end()
               ? -1
               : static_cast<int>(at - description.parameters.begin());
  };
  JudgedNumbers judged = find_judged_numbers(description);
  for (CheckedNumber& one : judged.by_rule) {
    const auto names = one.value.expression.names();
    if (std::ranges::any_of(names, [&](const auto& name) { return slot_of(name) < 0; })) {
      continue;  // of a law that names other quantities, too
    }
    Rule rule{.value = SlotExpression(std::move(one.value.expression), slot_of), .rule = one.rule};
    std::set<std::size_t> those;
    for (const int slot : rule.value.slots()) {
      those.insert(axes[static_cast<std::size_t>(slot)].begin(),
                   axes[static_cast<std::size_t>(slot)].end());
    }
    const bool is_checked_once =
        those.empty() || (those.size() == 1 && holds_on(plan, *those.begin(), rule));
    if (!is_checked_once) {
      rules_.push_back(std::move(rule));
    }
  }
}

bool StateRules::hold(const Slots& slots, std::vector<Quantity>& scratch) const {
  return std::ranges::all_of(rules_, [&](const Rule& rule) { return holds(rule, slots, scratch); });
}

bool StateRules::holds(const Rule& rule, const Slots& slots, std::vector<Quantity>& scratch) const {
  const std::optional<Quantity> value = rule.value.evaluate(slots, scratch);
  if (!value) {
    return false;
  }
  const auto number = fit<double>(*value, rule.rule.kind, units_);
  return std::holds_alternative<double>(number) && rule.rule.range.holds(std::get<double>(number));
}

bool StateRules::holds_on(const SweepPlan& plan, std::size_t axis, const Rule& rule) const {
  constexpr std::uint64_t kMostPlaces = 100'000;
  const SweepAxis& one = plan.axes()[axis];
  if (one.is_of_rows() || one.size() > kMostPlaces) {
    return false;
  }
  Slots slots = plan.slots();
  std::vector<Quantity> scratch;
  const auto slot = static_cast<std::size_t>(one.parameter());
  slots.has_value[slot] = true;
  for (std::uint64_t place = 0; place < one.size(); ++place) {
    slots.values[slot] = one.value_at(place);
    plan.evaluate_dependents(0, slots, scratch);
    if (!holds(rule, slots, scratch)) {
      return false;
    }
  }
  return true;
}

}  // namespace kinestat
