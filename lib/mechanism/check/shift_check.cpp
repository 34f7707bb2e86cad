#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "core/text.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/check/section_checks.hpp"

namespace kinestat {

namespace {

bool holds(const std::vector<Name>& list, std::string_view name) {
  return std::ranges::any_of(list, [&](const Name& one) { return one.text == name; });
}

std::vector<std::string> texts_of(const std::vector<Name>& list) {
  std::vector<std::string> texts;
  texts.reserve(list.size());
  for (const Name& name : list) {
    texts.push_back(name.text);
  }
  return texts;
}

// Which quantities an input's motion and action are.
struct Sides {
  QuantityKind turning = QuantityKind::angular_velocity;
  QuantityKind sliding = QuantityKind::velocity;
};

constexpr Sides kMotion = {.turning = QuantityKind::angular_velocity,
                           .sliding = QuantityKind::velocity};
constexpr Sides kAcceleration = {.turning = QuantityKind::angular_acceleration,
                                 .sliding = QuantityKind::acceleration};
constexpr Sides kAction = {.turning = QuantityKind::moment, .sliding = QuantityKind::force};

class ShiftCheck {
 public:
  ShiftCheck(const SectionContext& context, const ShiftDescription& shift)
      : context_(context), shift_(shift) {}

  void run() {
    check_actuators(shift_.inputs, "'input' of 'shift'");
    check_actuators(shift_.outputs, "'output' of 'shift'");
    check_actuators(shift_.elements, "'elements' of 'shift'");
    check_actuators(shift_.reacts, "'reacts' of 'shift'");
    check_reacting();
    check_roles();
    check_elements();
    check_values(shift_.input_motion, kMotion, "'input_motion'");
    check_values(shift_.input_action, kAction, "'input_action'");
    check_values(shift_.input_acceleration, kAcceleration, "'input_acceleration'");
    check_limits();
    for (const SlipDescription& slip : shift_.slips) {
      check_slip(slip);
    }
    for (const GearLabel& gear : shift_.names) {
      check_label(gear);
    }
    for (const CaseDescription& one : context_.description.cases) {
      const bool is_gear = one.label.where == shift_.where || is_label(one.label);
      if (!is_gear && !combination_of(one.label.text).empty()) {
        context_.found.error(
            "E0307",
            one.label.where,
            fmt::format("case '{}' has the name of a combination of shift elements",
                        one.label.text),
            "every gear is a case of the report; give the case another label");
      }
    }
  }

 private:
  void check_actuators(const std::vector<Name>& list, const std::string& what) {
    for (const Name& name : list) {
      context_.names.check_actuator(name, what + " names", context_.found);
    }
    context_.repeats(list, what);
  }

  // An actuator is one of input, output and element.
  void check_roles() {
    for (const Name& output : shift_.outputs) {
      if (holds(shift_.inputs, output.text)) {
        refuse_role(output, "both input and output");
      }
    }
    for (const Name& machine : shift_.reacts) {
      if (holds(shift_.inputs, machine.text)) {
        refuse_role(machine, "both input and what reacts");
      } else if (holds(shift_.outputs, machine.text)) {
        refuse_role(machine, "both output and what reacts");
      } else if (holds(shift_.elements, machine.text)) {
        refuse_role(machine, "both shift element and what reacts");
      }
    }
    for (const Name& element : shift_.elements) {
      if (holds(shift_.inputs, element.text)) {
        refuse_role(element, "both input and shift element");
      } else if (holds(shift_.outputs, element.text)) {
        refuse_role(element, "both output and shift element");
      }
    }
  }

  // Whether a case is a gear of the section that has become one.
  bool is_label(const Name& label) const {
    return std::ranges::any_of(
        shift_.names, [&](const GearLabel& gear) { return gear.label.where == label.where; });
  }

  const CouplingDescription* find_coupling(const Name& element) const {
    const std::vector<CouplingDescription>& couplings = context_.description.couplings;
    const auto at = std::ranges::find_if(
        couplings, [&](const CouplingDescription& one) { return one.name.text == element.text; });
    return at == couplings.end() ? nullptr : &*at;
  }

  // What engages and opens is a clutch or a brake, an actuator of its own name.
  void check_elements() {
    for (const Name& element : shift_.elements) {
      const CouplingDescription* coupling = find_coupling(element);
      const bool shifts = coupling != nullptr && kind_of(coupling->type).engages;
      if (!shifts && context_.names.actuators.contains(element.text) &&
          !holds(shift_.inputs, element.text) && !holds(shift_.outputs, element.text)) {
        context_.found.error("E0305",
                             element.where,
                             fmt::format("'{}' is neither a clutch nor a brake", element.text),
                             fmt::format("declare a coupling for it, {}: {{type: brake, bodies: "
                                         "[…, …], at: …}}, and name that",
                                         element.text + "_brake"));
      }
    }
  }

  void refuse_role(const Name& name, std::string_view roles) {
    context_.found.error("E0305",
                         name.where,
                         fmt::format("'{}' cannot be {}", name.text, roles),
                         "name it in one of the two; a shaft that is driven and shifted has an "
                         "actuator for each");
  }

  // Their speeds and torques are told as those of shafts.
  void check_reacting() {
    for (const Name& machine : shift_.reacts) {
      if (context_.names.kind_of_actuator(machine.text) == DriveKind::sliding) {
        context_.found.error("E0305",
                             machine.where,
                             fmt::format("machine '{}' of 'reacts' slides", machine.text),
                             "machines that react turn: name an actuator of a revolute");
      }
    }
  }

  void check_values(const std::vector<InputValue>& values,
                    const Sides& sides,
                    const std::string& what) {
    std::size_t at_rest = 0;
    for (const InputValue& one : values) {
      if (!one.target) {
        check_for_all(one.value, sides, what);
      } else if (holds(shift_.inputs, one.target->text)) {
        const DriveKind kind = context_.names.kind_of_actuator(one.target->text);
        const bool is_last = at_rest + 1 == shift_.inputs.size();
        const auto number = check_value(one.value, kind, sides, what, !is_last);
        at_rest += number == 0.0 ? 1 : 0;
      } else {
        context_.evaluator.quantity(one.value);
        check_target(*one.target, what);
      }
    }
  }

  // One value for inputs that turn and inputs that slide cannot fit both: the second one complains.
  void check_for_all(const Value& value, const Sides& sides, const std::string& what) {
    std::set<DriveKind> kinds;
    for (const Name& input : shift_.inputs) {
      kinds.insert(context_.names.kind_of_actuator(input.text));
    }
    if (kinds.contains(DriveKind::turning) && kinds.contains(DriveKind::sliding)) {
      context_.found.error("E0309",
                           value.where,
                           fmt::format("{} is one value for inputs that turn and slide", what),
                           fmt::format("write one for each: {{{}: …, {}: …}}",
                                       shift_.inputs[0].text,
                                       shift_.inputs[1].text));
      return;
    }
    for (const DriveKind kind : kinds) {
      check_value(value, kind, sides, what, false);
    }
  }

  // One of several inputs may rest, but not all.
  std::optional<double> check_value(const Value& value,
                                    DriveKind kind,
                                    const Sides& sides,
                                    const std::string& what,
                                    bool may_rest) {
    if (kind == DriveKind::unknown) {
      context_.evaluator.quantity(value);
      return std::nullopt;
    }
    const auto kind_of_value = kind == DriveKind::sliding ? sides.sliding : sides.turning;
    const NumberRule any = {.kind = kind_of_value, .range = kAnyNumber, .allowed = "a value"};
    const NumberRule rule = {
        .kind = kind_of_value,
        .range = kNotZero,
        .allowed = "a value other than zero: gears are seen only when the input works"};
    return context_.number(value, may_rest ? any : rule, what);
  }

  // Which gears there are, only their states tell.
  void check_slip(const SlipDescription& slip) {
    const std::string what = fmt::format("slip '{}'", slip.name.text);
    const auto number =
        [&](const std::optional<Value>& value, const NumberRule& rule, std::string_view key) {
          return context_.number(value, rule, fmt::format("'{}' of {}", key, what));
        };
    constexpr NumberRule kSpeed = {
        .kind = QuantityKind::angular_velocity, .range = kAnyNumber, .allowed = "a value"};
    constexpr NumberRule kTurning = {.kind = QuantityKind::angular_velocity,
                                     .range = kNotZero,
                                     .allowed =
                                         "a value other than zero: a gear at rest does not "
                                         "slip"};
    constexpr NumberRule kTorque = {
        .kind = QuantityKind::moment, .range = kAnyNumber, .allowed = "a value"};
    number(slip.input_speed, slip.from ? kTurning : kSpeed, "input_speed");
    number(slip.output_speed, kSpeed, "output_speed");
    number(slip.input_action, kTorque, "input_action");
    number(slip.output_action, kTorque, "output_action");
    check_limits(slip.capacity, QuantityKind::moment, fmt::format("'capacity' of {}", what), true);
    if (slip.capacity.size() > 1) {
      const Name& second = *slip.capacity[1].target;
      context_.found.error("E0712",
                           second.where,
                           fmt::format("'capacity' of {} names several elements", what),
                           "one element slips and the others are engaged or open: name the one "
                           "that engages, and give changes of several elements one by one");
    }
  }

  void check_limits() {
    if (!shift_.limits) {
      return;
    }
    const ShiftLimitsDescription& limits = *shift_.limits;
    check_limits(limits.torque, QuantityKind::moment, "'torque' of 'limits'", true);
    check_limits(limits.slip, QuantityKind::angular_velocity, "'slip' of 'limits'", true);
    check_limits(limits.speed, QuantityKind::angular_velocity, "'speed' of 'limits'", false);
    check_limits(
        limits.planet_speed, QuantityKind::angular_velocity, "'planet_speed' of 'limits'", false);
    if (!limits.torque.empty() && shift_.input_action.empty()) {
      context_.found.error("E0303",
                           limits.torque.front().value.where,
                           "'torque' of 'limits' needs the key 'input_action' of 'shift'",
                           "add the torque of the input, 'input_action: 100 N*m', or remove the "
                           "limit: without it no torque is known");
    }
  }

  void check_limits(const std::vector<InputValue>& limits,
                    QuantityKind kind,
                    const std::string& what,
                    bool is_of_elements) {
    const NumberRule rule = {
        .kind = kind, .range = kAboveZero, .allowed = "a value above zero: it is a magnitude"};
    for (const InputValue& one : limits) {
      context_.number(one.value, rule, what);
      if (one.target && !is_of_elements) {
        context_.names.bodies.check(*one.target, what + " names", context_.found);
      } else if (one.target && !holds(shift_.elements, one.target->text)) {
        refuse_element(*one.target, what, "names");
      }
    }
  }

  // Where an input itself is misspelt, an actuator here may well be the one that is meant.
  void check_target(const Name& target, const std::string& what) {
    const NameTable& actuators = context_.names.actuators;
    const bool are_inputs_known = std::ranges::all_of(
        shift_.inputs, [&](const Name& input) { return actuators.contains(input.text); });
    if (are_inputs_known || !actuators.contains(target.text)) {
      refuse_target(target, what);
    }
  }

  void refuse_target(const Name& target, const std::string& what) {
    const std::vector<std::string> inputs = texts_of(shift_.inputs);
    const std::string guess = did_you_mean(target.text, inputs);
    context_.found.error(
        "E0313",
        target.where,
        fmt::format("{} names '{}', which is not an input of 'shift'", what, target.text),
        fmt::format("inputs are {}{}{}", plain_list(inputs), guess.empty() ? "" : "; ", guess));
  }

  void check_label(const GearLabel& gear) {
    const std::string what = fmt::format("gear '{}'", gear.label.text);
    for (const Name& element : gear.elements) {
      if (!holds(shift_.elements, element.text)) {
        refuse_element(element, what, "engages");
      }
    }
    context_.repeats(gear.elements, what);
    if (context_.names.cases.contains(gear.label.text)) {
      const int index = context_.names.cases.find(gear.label.text);
      if (context_.names.cases.where(index) != gear.label.where) {  // not the gear as a case
        complain(gear.label,
                 fmt::format("{} has the label of a case", what),
                 "every gear is a case of the report; give one of the two another label",
                 context_.names.cases.where(index));
      }
    }
    const std::vector<std::string> list = texts_of(gear.elements);
    const std::set<std::string> engaged(list.begin(), list.end());
    check_combination_name(gear.label, engaged, what);
    const auto [at, is_new] = labels_.emplace(engaged, &gear);
    if (!is_new) {
      complain(gear.label,
               fmt::format("{} engages the same elements as '{}'", what, at->second->label.text),
               "correct the elements, or keep one of the two labels",
               at->second->label.where);
    }
  }

  // The elements of a text like "C1+B2"; none if it is not made of them.
  std::set<std::string> combination_of(const std::string& text) const {
    std::set<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find('+', begin), text.size());
      parts.insert(text.substr(begin, end - begin));
      begin = end + 1;
    }
    const bool is_combination = std::ranges::all_of(
        parts, [&](const std::string& part) { return holds(shift_.elements, part); });
    return is_combination ? parts : std::set<std::string>();
  }

  // States without a label are named by their elements.
  void check_combination_name(const Name& label,
                              const std::set<std::string>& engaged,
                              const std::string& what) {
    const std::set<std::string> named = combination_of(label.text);
    if (!named.empty() && named != engaged) {
      context_.found.error("E0307",
                           label.where,
                           fmt::format("{} engages other elements than its label says", what),
                           named.size() == 1
                               ? fmt::format("'{}' is an element, and a combination without a "
                                             "label is named by its elements; choose another label",
                                             label.text)
                               : "combinations without a label are named so; choose another label");
    }
  }

  void refuse_element(const Name& element, const std::string& what, std::string_view does) {
    const std::vector<std::string> elements = texts_of(shift_.elements);
    const std::string guess = did_you_mean(element.text, elements);
    context_.found.error(
        "E0313",
        element.where,
        fmt::format("{} {} '{}', which is not in 'elements'", what, does, element.text),
        fmt::format("elements are {}{}{}", plain_list(elements), guess.empty() ? "" : "; ", guess));
  }

  void complain(const Name& label, std::string message, std::string hint, SourceRange first) {
    auto& problem = context_.found.error("E0307", label.where, std::move(message), std::move(hint));
    problem.notes.push_back({first, "first declared here"});
  }

  const SectionContext& context_;
  const ShiftDescription& shift_;
  std::map<std::set<std::string>, const GearLabel*> labels_;
};

}  // namespace

void check_shift(const SectionContext& context) {
  if (context.description.shift) {
    ShiftCheck(context, *context.description.shift).run();
  }
}

}  // namespace kinestat
