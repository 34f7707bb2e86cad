#include "mechanism/shift_plan.hpp"

#include <algorithm>
#include <utility>

#include "core/contract.hpp"
#include "mechanism/cases/case_binder.hpp"
#include "mechanism/cases/load_binder.hpp"
#include "mechanism/couplings/freewheel.hpp"
#include "mechanism/inertia/mass_binder.hpp"
#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

int actuator_of(const Topology& topology, const Name& name) {
  const auto at = std::ranges::find(topology.actuators, name.text, &ActuatorTopology::name);
  KINESTAT_EXPECTS(at != topology.actuators.end());
  return static_cast<int>(at - topology.actuators.begin());
}

// The value that the section gives for an input: its own, or the one for all.
const Value* value_of(const std::vector<InputValue>& values, const Name& input) {
  for (const InputValue& one : values) {
    if (!one.target || one.target->text == input.text) {
      return &one.value;
    }
  }
  return nullptr;
}

// One action for all would prescribe more than equilibrium leaves open: it is that of the first
// input, from which those of the others follow.
bool is_left_to_equilibrium(const std::vector<InputValue>& actions, std::size_t input) {
  return input > 0 && actions.size() == 1 && !actions.front().target;
}

class ShiftBinder {
 public:
  ShiftBinder(const MechanismDescription& description, const Topology& topology)
      : description_(description),
        shift_(*description.shift),
        topology_(topology),
        evaluator_(make_evaluator(description, ignored_)) {}

  ShiftPlan run() {
    plan_.combinations = shift_.combinations;
    if (shift_.forward) {
      plan_.forward = *shift_.forward == ForwardRatios::positive ? 1.0 : -1.0;
    }
    for (std::size_t i = 0; i < shift_.inputs.size(); ++i) {
      add_input(i);
    }
    for (const Name& output : shift_.outputs) {
      plan_.outputs.push_back(actuator_of(topology_, output));
    }
    const std::vector<Freewheel> freewheels = bind_freewheels(description_, topology_);
    for (const Name& element : shift_.elements) {
      const int actuator = actuator_of(topology_, element);
      const int freedom = topology_.actuators[static_cast<std::size_t>(actuator)].freedom;
      const auto freewheel = std::ranges::find(freewheels, freedom, &Freewheel::freedom);
      plan_.elements.push_back(
          {.actuator = actuator, .one_way = freewheel == freewheels.end() ? 0 : freewheel->holds});
    }
    for (const GearLabel& label : shift_.names) {
      add_label(label);
    }
    if (shift_.limits) {
      add_limits(LimitKind::torque, shift_.limits->torque);
      add_limits(LimitKind::slip, shift_.limits->slip);
      add_limits(LimitKind::speed, shift_.limits->speed);
      add_limits(LimitKind::planet_speed, shift_.limits->planet_speed);
    }
    for (const SlipDescription& slip : shift_.slips) {
      add_slip(slip);
    }
    for (int a = 0; a < static_cast<int>(topology_.actuators.size()); ++a) {
      if (!has_part(a)) {
        const bool reacts = std::ranges::find(shift_.reacts,
                                              topology_.actuators[static_cast<std::size_t>(a)].name,
                                              &Name::text) != shift_.reacts.end();
        if (reacts) {
          plan_.reacting.push_back(static_cast<int>(plan_.others.size()));
        }
        plan_.others.push_back(a);
      }
    }
    for (ShiftInput& input : plan_.inputs) {
      if (plan_.is_hybrid() && !shift_.input_action.empty() && !input.action) {
        input.action = 0.0;
      }
    }
    plan_.asks_actions = !shift_.input_action.empty();
    plan_.where = shift_.where;
    return std::move(plan_);
  }

 private:
  void add_input(std::size_t i) {
    const Name& name = shift_.inputs[i];
    ShiftInput input;
    input.actuator = actuator_of(topology_, name);
    const ActuatorTopology& actuator =
        topology_.actuators[static_cast<std::size_t>(input.actuator)];
    if (const Value* speed = value_of(shift_.input_motion, name)) {
      const bool turns = topology_.freedoms[static_cast<std::size_t>(actuator.freedom)].is_rotation;
      input.speed = evaluator_.number(*speed, rate_kind(turns)).value_or(input.speed);
    }
    const Value* action = value_of(shift_.input_action, name);
    if (action != nullptr && !is_left_to_equilibrium(shift_.input_action, i)) {
      const bool is_couple = topology_.actions[static_cast<std::size_t>(actuator.action)].is_couple;
      input.action = evaluator_.number(*action, action_kind(is_couple));
    }
    plan_.inputs.push_back(input);
  }

  bool has_part(int actuator) const {
    return std::ranges::find(plan_.inputs, actuator, &ShiftInput::actuator) != plan_.inputs.end() ||
           std::ranges::find(plan_.outputs, actuator) != plan_.outputs.end() ||
           std::ranges::find(plan_.elements, actuator, &ShiftElement::actuator) !=
               plan_.elements.end();
  }

  void add_label(const GearLabel& label) {
    ShiftLabel result{.text = label.label.text, .engaged = {}, .where = label.label.where};
    for (const Name& element : label.elements) {
      result.engaged.push_back(index_of(shift_.elements, element.text, &Name::text));
    }
    std::ranges::sort(result.engaged);
    plan_.labels.push_back(std::move(result));
  }

  void add_limits(LimitKind kind, const std::vector<InputValue>& limits) {
    const bool is_of_elements = kind == LimitKind::torque || kind == LimitKind::slip;
    for (const InputValue& one : limits) {
      ShiftLimit limit{.kind = kind, .where = one.value.where};
      if (one.target) {
        limit.index = is_of_elements
                          ? index_of(shift_.elements, one.target->text, &Name::text)
                          : index_of(topology_.bodies, one.target->text, &BodyTopology::name);
      }
      limit.most = evaluator_.number(one.value, quantity_of(kind)).value_or(limit.most);
      plan_.limits.push_back(limit);
    }
  }

  void add_slip(const SlipDescription& slip) {
    const auto number = [&](const std::optional<Value>& value, QuantityKind kind) {
      return value ? evaluator_.number(*value, kind) : std::nullopt;
    };
    const InputValue& capacity = slip.capacity.front();
    plan_.slips.push_back(
        {.name = slip.name,
         .from = slip.from,
         .to = slip.to,
         .input_speed = number(slip.input_speed, QuantityKind::angular_velocity).value_or(0.0),
         .output_speed = number(slip.output_speed, QuantityKind::angular_velocity),
         .input_action = number(slip.input_action, QuantityKind::moment).value_or(0.0),
         .output_action = number(slip.output_action, QuantityKind::moment).value_or(0.0),
         .element = capacity.target ? std::optional(index_of(
                                          shift_.elements, capacity.target->text, &Name::text))
                                    : std::nullopt,
         .capacity = evaluator_.number(capacity.value, QuantityKind::moment).value_or(0.0),
         .where_capacity = capacity.target ? capacity.target->where : capacity.value.where});
  }

  template <class List, class Projection>
  static int index_of(const List& list, std::string_view name, Projection projection) {
    const auto at = std::ranges::find(list, name, projection);
    KINESTAT_EXPECTS(at != list.end());
    return static_cast<int>(at - list.begin());
  }

  const MechanismDescription& description_;
  const ShiftDescription& shift_;
  const Topology& topology_;
  Diagnostics ignored_;
  Evaluator evaluator_;
  ShiftPlan plan_;
};

Value plain_number(std::string_view text, SourceRange where) {
  return {
      .expression = std::get<Expression>(parse_expression(text)), .where = where, .text_column = 0};
}

class GearDescriber {
 public:
  GearDescriber(const MechanismDescription& description,
                const Topology& topology,
                const ShiftPlan& plan)
      : shift_(*description.shift),
        has_loads_(!description.loads.empty() || description.gravity),
        topology_(topology),
        plan_(plan) {}

  CaseDescription describe(const GearCase& gear) const {
    CaseDescription result{.label = {.text = gear.label, .where = gear.where},
                           .asks_motions = true,
                           .asks_actions = plan_.asks_actions,
                           .motions = {},
                           .actions = {},
                           .loads = {},
                           .inputs = shift_.inputs,
                           .outputs = shift_.outputs,
                           .is_gear = true};
    add_motions(gear, result);
    if (!shift_.input_acceleration.empty()) {
      add_accelerations(gear, result);
    }
    if (plan_.asks_actions || has_loads_) {
      add_actions(gear, result);
    }
    return result;
  }

 private:
  Assignment nothing(const std::string& name, const GearCase& gear) const {
    return {.target = {.text = name, .where = gear.where}, .value = plain_number("0", gear.where)};
  }

  void add_motions(const GearCase& gear, CaseDescription& result) const {
    for (const int i : gear.moving) {
      const Name& input = shift_.inputs[static_cast<std::size_t>(i)];
      const Value* given = value_of(shift_.input_motion, input);
      result.motions.push_back({.target = {.text = input.text, .where = gear.where},
                                .value = given ? *given : plain_number("1", gear.where)});
    }
    for (const int e : gear.engaged) {
      result.motions.push_back(nothing(shift_.elements[static_cast<std::size_t>(e)].text, gear));
    }
  }

  void add_accelerations(const GearCase& gear, CaseDescription& result) const {
    result.has_inertia = true;
    for (const int i : gear.moving) {
      const Name& input = shift_.inputs[static_cast<std::size_t>(i)];
      if (const Value* given = value_of(shift_.input_acceleration, input)) {
        result.accelerations.push_back(
            {.target = {.text = input.text, .where = gear.where}, .value = *given});
      }
    }
  }

  void add_actions(const GearCase& gear, CaseDescription& result) const {
    for (std::size_t i = 0; i < shift_.inputs.size(); ++i) {
      const Value* given = value_of(shift_.input_action, shift_.inputs[i]);
      if (given != nullptr && !is_left_to_equilibrium(shift_.input_action, i)) {
        result.actions.push_back(
            {.target = {.text = shift_.inputs[i].text, .where = gear.where}, .value = *given});
      } else if (plan_.is_hybrid() && plan_.asks_actions) {
        result.actions.push_back(nothing(shift_.inputs[i].text, gear));
      }
    }
    for (const int e : gear.open) {
      result.actions.push_back(nothing(shift_.elements[static_cast<std::size_t>(e)].text, gear));
    }
    for (const int o : gear.others) {
      const int actuator = plan_.others[static_cast<std::size_t>(o)];
      result.actions.push_back(
          nothing(topology_.actuators[static_cast<std::size_t>(actuator)].name, gear));
    }
  }

  const ShiftDescription& shift_;
  bool has_loads_ = false;
  const Topology& topology_;
  const ShiftPlan& plan_;
};

}  // namespace

std::optional<ShiftPlan> bind_shift(const MechanismDescription& description,
                                    const Topology& topology) {
  return description.shift ? std::optional(ShiftBinder(description, topology).run()) : std::nullopt;
}

std::vector<CaseDescription> describe_gears(const MechanismDescription& description,
                                            const Topology& topology,
                                            const ShiftPlan& plan,
                                            const std::vector<GearCase>& gears) {
  const GearDescriber describer(description, topology, plan);
  std::vector<CaseDescription> cases;
  for (const GearCase& gear : gears) {
    cases.push_back(describer.describe(gear));
  }
  return cases;
}

Case bind_slip_loads(const MechanismDescription& description, const Mechanism& mechanism) {
  MechanismDescription alone = description;
  alone.cases = {CaseDescription{}};
  return bind_described_cases(alone, mechanism).front();
}

std::vector<Case> bind_described_cases(const MechanismDescription& description,
                                       const Mechanism& mechanism) {
  Diagnostics said_before;
  Evaluator evaluator = make_evaluator(description, said_before);
  const DeclaredNames names = declare_names(description, said_before);
  const SectionContext context = {
      .description = description, .names = names, .evaluator = evaluator, .found = said_before};
  evaluator.measure_from(mechanism.geometry.origin);
  std::vector<Case> cases =
      bind_cases(description, mechanism.topology, mechanism.curves, evaluator, said_before);
  KINESTAT_EXPECTS(!said_before.has_errors());
  std::vector<CaseLoads> loads = bind_loads(context, bind_masses(context), mechanism.curves);
  place_gear_weights(context, mechanism.masses, loads);
  add_loads(std::move(loads), cases);
  return cases;
}

}  // namespace kinestat
