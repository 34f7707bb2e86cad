#include "mechanism/internal/case_binder.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"

namespace kinestat {

namespace {

enum class Side { motion, action };

class CaseBinder {
 public:
  CaseBinder(const Topology& topology, Evaluator& evaluator, Diagnostics& found)
      : topology_(topology), evaluator_(evaluator), found_(found) {
    for (int f = 0; f < topology.freedom_count(); ++f) {
      freedoms_.push_back(topology.freedom_name(f));
    }
    for (int a = 0; a < topology.action_count(); ++a) {
      actions_.push_back(topology.action_name(a));
    }
    for (const ActuatorTopology& actuator : topology.actuators) {
      actuators_.push_back(actuator.name);
    }
  }

  Case bind(const CaseDescription& description) {
    Case result{.label = description.label.text,
                .asks_motions = description.asks_motions,
                .asks_actions = description.asks_actions,
                .motions = bind_side(description.motions, Side::motion),
                .actions = bind_side(description.actions, Side::action),
                .inputs = bind_actuators(description.inputs),
                .outputs = bind_actuators(description.outputs),
                .where = description.label.where};
    return result;
  }

 private:
  std::vector<Primary> bind_side(const std::vector<Assignment>& assignments, Side side) {
    std::vector<Primary> primaries;
    for (const Assignment& assignment : assignments) {
      const std::optional<int> index = resolve(assignment.target, side);
      const std::optional<double> value =
          index ? evaluator_.number(assignment.value, kind_of(*index, side)) : std::nullopt;
      if (!value) {
        continue;
      }
      const auto twin = std::ranges::find(primaries, *index, &Primary::index);
      if (twin != primaries.end()) {
        auto& problem = found_.error(
            side == Side::motion ? "E0502" : "E0601",
            assignment.target.where,
            fmt::format("'{}' is already given as '{}'", assignment.target.text, twin->given),
            "keep one of the two");
        problem.notes.push_back({twin->where, "first given here"});
        continue;
      }
      primaries.push_back({.index = *index,
                           .value = *value,
                           .given = assignment.target.text,
                           .where = assignment.target.where});
    }
    return primaries;
  }

  QuantityKind kind_of(int index, Side side) const {
    const auto i = static_cast<std::size_t>(index);
    if (side == Side::motion) {
      return topology_.freedoms[i].is_rotation ? QuantityKind::angular_velocity
                                               : QuantityKind::velocity;
    }
    return topology_.actions[i].is_couple ? QuantityKind::moment : QuantityKind::force;
  }

  // An actuator, or coupling.freedom, or coupling.action.
  std::optional<int> resolve(const Name& target, Side side) {
    const auto actuator = std::ranges::find(actuators_, target.text);
    if (actuator != actuators_.end()) {
      const auto& found =
          topology_.actuators[static_cast<std::size_t>(actuator - actuators_.begin())];
      return side == Side::motion ? found.freedom : found.action;
    }
    const std::vector<std::string>& names = side == Side::motion ? freedoms_ : actions_;
    const auto at = std::ranges::find(names, target.text);
    if (at != names.end()) {
      return static_cast<int>(at - names.begin());
    }
    complain(target, side, names);
    return std::nullopt;
  }

  void complain(const Name& target, Side side, const std::vector<std::string>& names) {
    std::vector<std::string> candidates = actuators_;
    std::vector<std::string> same_coupling;
    const std::string prefix = target.text.substr(0, target.text.find('.')) + ".";
    for (const std::string& name : names) {
      if (std::ranges::find(candidates, name) == candidates.end()) {
        candidates.push_back(name);
      }
      if (name.starts_with(prefix)) {
        same_coupling.push_back(name);
      }
    }
    const std::string guess = did_you_mean(target.text, candidates);
    const std::string_view word = side == Side::motion ? "motion" : "action";
    std::string hint =
        same_coupling.empty()
            ? fmt::format(
                  "actuators are {}; {}s are {}", plain_list(actuators_), word, plain_list(names))
            : fmt::format("that coupling has {}", plain_list(same_coupling));
    found_.error(
        "E0313",
        target.where,
        fmt::format("'{}' is neither an actuator nor the {} of a coupling", target.text, word),
        guess.empty() ? hint : fmt::format("{} {}", guess, hint));
  }

  std::vector<int> bind_actuators(const std::vector<Name>& names) {
    std::vector<int> result;
    for (const Name& name : names) {
      const auto at = std::ranges::find(actuators_, name.text);
      if (at != actuators_.end()) {
        result.push_back(static_cast<int>(at - actuators_.begin()));
        continue;
      }
      const std::string guess = did_you_mean(name.text, actuators_);
      found_.error("E0313",
                   name.where,
                   fmt::format("'{}' is not an actuator", name.text),
                   actuators_.empty() ? "declare it under 'actuators:'"
                                      : fmt::format("{}{}actuators are {}",
                                                    guess,
                                                    guess.empty() ? "" : " ",
                                                    plain_list(actuators_)));
    }
    return result;
  }

  const Topology& topology_;
  Evaluator& evaluator_;
  Diagnostics& found_;
  std::vector<std::string> freedoms_;
  std::vector<std::string> actions_;
  std::vector<std::string> actuators_;
};

}  // namespace

std::vector<Case> bind_cases(const MechanismDescription& description,
                             const Topology& topology,
                             Evaluator& evaluator,
                             Diagnostics& found) {
  CaseBinder binder(topology, evaluator, found);
  std::vector<Case> cases;
  for (const CaseDescription& one : description.cases) {
    cases.push_back(binder.bind(one));
  }
  return cases;
}

}  // namespace kinestat
