#include "mechanism/cases/case_binder.hpp"

#include <algorithm>
#include <unordered_map>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "mechanism/curves/moving_number_binder.hpp"
#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

enum class Side { motion, acceleration, action };

// Names with their places in a list of the topology; of two alike the first counts.
class Index {
 public:
  void add(std::string name) {
    if (index_.emplace(name, static_cast<int>(names_.size())).second) {
      names_.push_back(std::move(name));
    }
  }

  std::optional<int> find(const std::string& name) const {
    const auto at = index_.find(name);
    return at == index_.end() ? std::nullopt : std::optional(at->second);
  }

  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string, int> index_;  // looked up only, never walked through
};

class CaseBinder {
 public:
  CaseBinder(const MechanismDescription& description,
             const Topology& topology,
             std::span<const Curve> curves,
             Evaluator& evaluator,
             Diagnostics& found)
      : topology_(topology),
        curves_(curves),
        evaluator_(evaluator),
        found_(found),
        has_gravity_(description.gravity.has_value()) {
    add_loads(description.loads);
    for (const CaseDescription& one : description.cases) {
      add_loads(one.loads);
    }
    for (const BodyDescription& body : description.bodies) {
      if (body.mass && description.gravity) {
        power_loads_.add(std::string(kWeightPrefix) + body.name.text);
      }
    }
    for (int f = 0; f < topology.freedom_count(); ++f) {
      freedoms_.add(topology.freedom_name(f));
    }
    for (int a = 0; a < topology.action_count(); ++a) {
      actions_.add(topology.action_name(a));
    }
    for (const ActuatorTopology& actuator : topology.actuators) {
      actuators_.add(actuator.name);
    }
  }

  Case bind(const CaseDescription& description) {
    Case result{.label = description.label.text,
                .asks_motions = description.asks_motions,
                .asks_actions = description.asks_actions,
                .motions = bind_side(description.motions, Side::motion),
                .actions = bind_side(description.actions, Side::action),
                .accelerations =
                    description.has_inertia
                        ? std::optional(bind_side(description.accelerations, Side::acceleration))
                        : std::nullopt,
                .loads = {},
                .inputs = bind_actuators(description.inputs),
                .outputs = bind_actuators(description.outputs),
                .where = description.label.where,
                .is_gear = description.is_gear};
    if (result.accelerations) {
      check_accelerations(description, result);
    }
    check_ends(description);
    return result;
  }

 private:
  void add_loads(const std::vector<LoadDescription>& loads) {
    for (const LoadDescription& load : loads) {
      loads_.add(load.name.text);
      power_loads_.add(load.name.text);
    }
  }

  // What speeds up has a known speed.
  void check_accelerations(const CaseDescription& description, const Case& result) {
    for (const Primary& one : *result.accelerations) {
      const bool is_known =
          std::ranges::find(result.motions, one.index, &Primary::index) != result.motions.end();
      if (is_known) {
        continue;
      }
      std::vector<std::string> known;
      for (const Primary& motion : result.motions) {
        known.push_back(motion.given);
      }
      found_.error("E0502",
                   one.where,
                   fmt::format("case '{}' has an acceleration of '{}' but not its motion",
                               printable(description.label.text),
                               one.given),
                   known.empty()
                       ? fmt::format("add its speed to 'motion': {{{}: 0}}", one.given)
                       : fmt::format("accelerations are of what 'motion' names, {}; add it there "
                                     "or remove it here",
                                     plain_list(known)));
    }
  }

  // No actuator is named twice, be it as input, as output or as both.
  void check_ends(const CaseDescription& description) {
    std::vector<Name> seen;
    const auto check = [&](const std::vector<Name>& names, std::string_view role) {
      for (const Name& name : names) {
        const auto twin = std::ranges::find(seen, name.text, &Name::text);
        if (twin == seen.end()) {
          seen.push_back(name);
          continue;
        }
        const bool is_input = twin - seen.begin() < std::ssize(description.inputs);
        const bool is_both = is_input && role == "output";
        auto& problem = found_.error(
            "E0307",
            name.where,
            is_both ? fmt::format("'{}' is input and output of case '{}'",
                                  name.text,
                                  printable(description.label.text))
                    : fmt::format("'{}' is named twice as {}", name.text, role),
            is_both ? "give one of the two another actuator" : "remove one of the two");
        problem.notes.push_back(
            {twin->where, is_both ? "named as input here" : "first named here"});
      }
    };
    check(description.inputs, "input");
    check(description.outputs, "output");
  }

  std::vector<Primary> bind_side(const std::vector<Assignment>& assignments, Side side) {
    std::vector<Primary> primaries;
    for (const Assignment& assignment : assignments) {
      const std::optional<int> index = resolve(assignment.target, side);
      const std::optional<MovingNumber> value =
          index ? number(assignment.value, kind_of(*index, side), side) : std::nullopt;
      if (!value) {
        continue;
      }
      const auto twin = std::ranges::find(primaries, *index, &Primary::index);
      if (twin != primaries.end()) {
        auto& problem = found_.error(
            side == Side::action ? "E0601" : "E0502",
            assignment.target.where,
            fmt::format("'{}' is already given as '{}'", assignment.target.text, twin->given),
            "keep one of the two");
        problem.notes.push_back({twin->where, "first given here"});
        continue;
      }
      primaries.push_back({.index = *index,
                           .value = value->value,
                           .given = assignment.target.text,
                           .where = assignment.target.where,
                           .law = value->law});
    }
    return primaries;
  }

  // Actions alone may follow curves.
  std::optional<MovingNumber> number(const Value& value, QuantityKind kind, Side side) {
    return bind_moving_number(
        value, kind, side == Side::action ? curves_ : std::span<const Curve>(), evaluator_);
  }

  QuantityKind kind_of(int index, Side side) const {
    const auto i = static_cast<std::size_t>(index);
    if (side == Side::motion) {
      return rate_kind(topology_.freedoms[i].is_rotation);
    }
    if (side == Side::acceleration) {
      return topology_.freedoms[i].is_rotation ? QuantityKind::angular_acceleration
                                               : QuantityKind::acceleration;
    }
    return action_kind(topology_.actions[i].is_couple);
  }

  // An actuator, or coupling.freedom, or coupling.action.
  std::optional<int> resolve(const Name& target, Side side) {
    if (const std::optional<int> actuator = actuators_.find(target.text)) {
      const auto& found = topology_.actuators[static_cast<std::size_t>(*actuator)];
      return side == Side::action ? found.action : found.freedom;
    }
    const Index& index = side == Side::action ? actions_ : freedoms_;
    const std::optional<int> at = index.find(target.text);
    if (!at && loads_.find(target.text)) {
      found_.error("E0313",
                   target.where,
                   fmt::format("'{}' is a load and needs no value here", target.text),
                   "remove it: loads act in every case; 'loads:' of the case replaces one");
    } else if (!at) {
      complain(target, side, index.names());
    }
    return at;
  }

  void complain(const Name& target, Side side, const std::vector<std::string>& names) {
    const std::string_view word = side == Side::action ? "action" : "motion";
    auto& problem = found_.error(
        "E0313",
        target.where,
        fmt::format(
            "'{}' is neither an actuator nor the {} of a coupling", printable(target.text), word));
    if (found_.is_hint_worth_it()) {
      problem.hint = hint_for(target, word, names);
    }
  }

  // "actuators are M1, M2; "
  std::string actuators_text() const {
    return actuators_.names().empty()
               ? "there are no actuators; "
               : fmt::format("actuators are {}; ", plain_list(actuators_.names()));
  }

  // "did you mean 'a.wz'? that coupling has a.wz"
  std::string hint_for(const Name& target,
                       std::string_view word,
                       const std::vector<std::string>& names) const {
    std::vector<std::string> candidates = actuators_.names();
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
    const std::string hint =
        same_coupling.empty()
            ? fmt::format("{}{}s are {}", actuators_text(), word, plain_list(names))
            : fmt::format("write {}, or declare an actuator on that coupling",
                          fmt::join(same_coupling, " or "));
    return guess_before(target.text, candidates, hint);
  }

  // "did you mean 'motor'? actuators are motor, press; loads are F, gravity.ram"
  std::string end_hint(const Name& name) const {
    const std::vector<std::string>& actuators = actuators_.names();
    const std::vector<std::string>& loads = power_loads_.names();
    std::vector<std::string> candidates = actuators;
    candidates.insert(candidates.end(), loads.begin(), loads.end());
    if (candidates.empty()) {
      return "declare it under 'actuators:'";
    }
    std::vector<std::string> parts;
    if (!actuators.empty()) {
      parts.push_back("actuators are " + plain_list(actuators));
    }
    if (!loads.empty()) {
      parts.push_back("loads are " + plain_list(loads));
    }
    return guess_before(name.text, candidates, fmt::format("{}", fmt::join(parts, "; ")));
  }

  std::vector<int> bind_actuators(const std::vector<Name>& names) {
    std::vector<int> result;
    for (const Name& name : names) {
      if (const std::optional<int> at = actuators_.find(name.text)) {
        result.push_back(*at);
        continue;
      }
      const bool lacks_gravity = !has_gravity_ && name.text.starts_with(kWeightPrefix);
      if (power_loads_.find(name.text) || lacks_gravity) {
        continue;  // bind_load_ends
      }
      found_.error("E0313",
                   name.where,
                   fmt::format("'{}' is neither an actuator nor a load", name.text),
                   end_hint(name));
    }
    return result;
  }

  const Topology& topology_;
  std::span<const Curve> curves_;
  Evaluator& evaluator_;
  Diagnostics& found_;
  bool has_gravity_;
  Index freedoms_;
  Index actions_;
  Index actuators_;
  Index loads_;
  Index power_loads_;  ///< these, and the weights
};

}  // namespace

std::vector<Case> bind_cases(const MechanismDescription& description,
                             const Topology& topology,
                             std::span<const Curve> curves,
                             Evaluator& evaluator,
                             Diagnostics& found) {
  CaseBinder binder(description, topology, curves, evaluator, found);
  std::vector<Case> cases;
  for (const CaseDescription& one : description.cases) {
    cases.push_back(binder.bind(one));
  }
  if (description.simulation) {
    // For what is wrong with it: simulations make a case of it where they need one.
    (void)binder.bind(case_of(*description.simulation));
  }
  return cases;
}

}  // namespace kinestat
