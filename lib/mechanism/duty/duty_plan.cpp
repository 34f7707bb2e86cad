#include "mechanism/duty/duty_plan.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/duty/internal/duty_knowns.hpp"

namespace kinestat {

namespace {

class DutyBinder {
 public:
  DutyBinder(const MechanismDescription& description,
             const Mechanism& mechanism,
             Diagnostics& found)
      : duty_(*description.duty),
        mechanism_(mechanism),
        found_(found),
        evaluator_(make_evaluator(description, said_before_).complaining_to(found)) {}

  std::optional<DutyPlan> run() {
    const int errors_before = found_.error_count();
    DutyPlan plan;
    if (duty_.repetitions) {
      plan.repetitions = number(*duty_.repetitions, QuantityKind::dimensionless);
    }
    for (const auto& [from, to] : {std::pair(&duty_.gear_exponent, &plan.gear_exponent),
                                   std::pair(&duty_.bearing_exponent, &plan.bearing_exponent)}) {
      if (*from) {
        *to = number(**from, QuantityKind::dimensionless);
      }
    }
    for (const DutyPointDescription& one : duty_.points) {
      add_point(one, plan);
    }
    return found_.error_count() == errors_before ? std::optional(std::move(plan)) : std::nullopt;
  }

 private:
  double number(const Value& value, QuantityKind kind) {
    return evaluator_.number(value, kind).value_or(1.0);
  }

  void add_point(const DutyPointDescription& one, DutyPlan& plan) {
    const std::optional<std::size_t> which = case_of(one);
    if (!which) {
      return;
    }
    DutyPoint point = point_of(mechanism_, *which);
    point.where = one.where;
    point.duration = number(one.duration, QuantityKind::time);
    set_values(one.input_motion, DutySide::motion, point);
    set_values(one.input_action, DutySide::action, point);
    plan.points.push_back(std::move(point));
  }

  std::optional<std::size_t> case_of(const DutyPointDescription& one) {
    const std::optional<Name>& name = one.case_label ? one.case_label : duty_.case_label;
    const std::optional<std::size_t> which = name ? find_case(mechanism_, name->text)
                                             : mechanism_.cases.size() == 1
                                                 ? std::optional<std::size_t>(0)
                                                 : std::nullopt;
    if (which) {
      if (const std::string why = why_no_point(mechanism_.cases[*which]); !why.empty()) {
        found_.error("E0303", name ? name->where : one.where, why, std::string(kBothSidesHint));
        return std::nullopt;
      }
    } else {
      found_.error("E0313",
                   name ? name->where : one.where,
                   name ? fmt::format("there is no case or gear '{}'", name->text)
                        : std::string("a point of 'duty' names no case"),
                   cases_hint(mechanism_, name ? name->text : ""));
    }
    return which;
  }

  void set_values(const std::vector<InputValue>& values, DutySide side, DutyPoint& point) {
    for (const InputValue& one : values) {
      if (one.target) {
        set_value(one, one.target->text, one.target->where, side, point);
        continue;
      }
      bool is_set = false;
      for (const int input : mechanism_.cases[point.which].inputs) {
        const auto actuator = static_cast<std::size_t>(input);
        if (find_known(mechanism_, point.which, actuator, side)) {
          const std::string& name = mechanism_.topology.actuators[actuator].name;
          set_value(one, name, one.value.where, side, point);
          is_set = true;
        }
      }
      if (!is_set) {
        found_.error("E0313",
                     one.value.where,
                     fmt::format("case '{}' gives no {} of an input",
                                 mechanism_.cases[point.which].label,
                                 word_of(side)),
                     hint_of_known(side, point));
      }
    }
  }

  // The actuators that the case gives: only their values can be others in a point.
  std::string hint_of_known(DutySide side, const DutyPoint& point) const {
    const std::vector<ActuatorTopology>& actuators = mechanism_.topology.actuators;
    for (std::size_t i = 0; i < actuators.size(); ++i) {
      if (find_known(mechanism_, point.which, i, side)) {
        return fmt::format("the case gives that of '{}': input_{}: {{{}: VALUE}}",
                           actuators[i].name,
                           word_of(side),
                           actuators[i].name);
      }
    }
    return fmt::format("give the case the {} of an input", word_of(side));
  }

  void set_value(const InputValue& one,
                 const std::string& name,
                 SourceRange where,
                 DutySide side,
                 DutyPoint& point) {
    const std::optional<std::size_t> actuator = find_actuator(mechanism_.topology, name);
    const std::optional<std::size_t> known =
        actuator ? find_known(mechanism_, point.which, *actuator, side) : std::nullopt;
    if (!known) {
      found_.error("E0313",
                   where,
                   actuator ? fmt::format("case '{}' does not give the {} of '{}'",
                                          mechanism_.cases[point.which].label,
                                          word_of(side),
                                          name)
                            : fmt::format("there is no actuator '{}'", name),
                   actuator ? fmt::format("the {} of '{}' follows from the others there; {}",
                                          word_of(side),
                                          name,
                                          hint_of_known(side, point))
                            : "name an actuator of the file");
      return;
    }
    const auto value =
        evaluator_.number(one.value, measure_of(mechanism_.topology, *actuator, side));
    set_known(*known, side, value.value_or(0.0), point);
  }

  const DutyDescription& duty_;
  const Mechanism& mechanism_;
  Diagnostics& found_;
  Diagnostics said_before_;
  Evaluator evaluator_;
};

}  // namespace

std::string place_of(const DutyPlan& plan, std::size_t point) {
  const int line = plan.points[point].line;
  return line > 0 ? fmt::format("in line {}", line) : fmt::format("point {}", point + 1);
}

std::optional<DutyPlan> bind_duty(const MechanismDescription& description,
                                  const Mechanism& mechanism,
                                  Diagnostics& found) {
  return DutyBinder(description, mechanism, found).run();
}

}  // namespace kinestat
