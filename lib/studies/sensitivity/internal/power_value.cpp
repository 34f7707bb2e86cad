#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "studies/sensitivity/internal/value_path.hpp"

namespace kinestat {

namespace {

using Found = std::optional<ReportedValue>;

// The powers of a case as formulas, as find_power has them.
class PowerFormula {
 public:
  explicit PowerFormula(const DualCase& values) : values_(values), topology_(values.topology()) {}

  // Needs all frictions and the actions of all actuators.
  bool exists() const {
    return values_.action()->open_friction.empty() &&
           std::ranges::all_of(topology_.actuators, [&](const ActuatorTopology& actuator) {
             return values_.real_magnitude(static_cast<std::size_t>(actuator.action)).has_value();
           });
  }

  Found find(const PathParts& parts) const {
    if (parts.size() == 2) {
      return parts[1] == "input" ? as_value(QuantityKind::power, input()) : std::nullopt;
    }
    if (parts.size() != 3) {
      return std::nullopt;
    }
    if (parts[1] == "efficiency") {
      return parts[2] == "friction" ? efficiency() : std::nullopt;
    }
    return as_value(QuantityKind::power, power_of(parts[1], parts[2]));
  }

 private:
  std::optional<Dual> power_of(const std::string& group, const std::string& name) const {
    if (group == "actuators") {
      const auto i = index_of(topology_.actuators, name);
      return i ? std::optional(of_actuator(*i)) : std::nullopt;
    }
    if (group == "loads") {
      const auto i = index_of(values_.which().loads, name);
      return i ? std::optional(of_load(*i)) : std::nullopt;
    }
    const auto e = index_of(topology_.couplings, name);
    if (!e) {
      return std::nullopt;
    }
    if (group == "couplings") {
      const auto wrench = real_wrench(*e);
      const auto head = static_cast<std::size_t>(topology_.couplings[*e].head.value);
      return wrench ? std::optional(power(*wrench, values_.body_twist(head))) : std::nullopt;
    }
    if (group == "supplied") {
      return supplied(*e);
    }
    return group == "friction" ? of_friction(*e) : std::nullopt;
  }

  // Empty where it is open, or a convention.
  std::optional<WrenchOf<Dual>> real_wrench(std::size_t coupling) const {
    return is_by_convention(*values_.action(), topology_.couplings[coupling])
               ? std::nullopt
               : values_.coupling_wrench(coupling);
  }

  Dual of_actuator(std::size_t i) const {
    const ActuatorTopology& actuator = topology_.actuators[i];
    return *values_.magnitude(static_cast<std::size_t>(actuator.action)) *
           values_.rate(static_cast<std::size_t>(actuator.freedom));
  }

  Dual of_load(std::size_t i) const {
    const auto body = static_cast<std::size_t>(values_.which().loads[i].acts.body.value);
    return power(values_.load_wrench(i), values_.body_twist(body));
  }

  // Empty for a coupling without friction.
  std::optional<Dual> of_friction(std::size_t coupling) const {
    for (std::size_t i = 0; i < values_.friction_count(); ++i) {
      if (values_.friction_law(i).coupling.value == static_cast<int>(coupling)) {
        return power(values_.friction_wrench(i), values_.coupling_twist(coupling));
      }
    }
    return std::nullopt;
  }

  // Where passive constraints have no value, by the rest: these do no work.
  Dual supplied(std::size_t coupling) const {
    if (const auto wrench = real_wrench(coupling)) {
      return power(*wrench, values_.coupling_twist(coupling));
    }
    Dual sum = of_friction(coupling).value_or(Dual(0.0));
    for (std::size_t i = 0; i < topology_.actuators.size(); ++i) {
      const auto f = static_cast<std::size_t>(topology_.actuators[i].freedom);
      if (topology_.freedoms[f].coupling.value == static_cast<int>(coupling)) {
        sum = sum + of_actuator(i);
      }
    }
    return sum;
  }

  Dual sum_of(const std::vector<int>& actuators, const std::vector<std::size_t>& loads) const {
    Dual sum(0.0);
    for (const int i : actuators) {
      sum = sum + of_actuator(static_cast<std::size_t>(i));
    }
    for (const std::size_t i : loads) {
      sum = sum + of_load(i);
    }
    return sum;
  }

  // Of the inputs, else of all actuators and loads that drive.
  Dual input() const {
    const Case& which = values_.which();
    if (!which.inputs.empty() || !which.input_loads.empty()) {
      return sum_of(which.inputs, which.input_loads);
    }
    Dual sum(0.0);
    for (std::size_t i = 0; i < topology_.actuators.size(); ++i) {
      sum = sum + max(of_actuator(i), Dual(0.0));
    }
    for (std::size_t i = 0; i < values_.which().loads.size(); ++i) {
      sum = sum + max(of_load(i), Dual(0.0));
    }
    return sum;
  }

  // Whether all power comes from the inputs and goes to the outputs and into friction.
  bool is_between_inputs_and_outputs() const {
    const Case& which = values_.which();
    double largest = 0.0;
    double beside = 0.0;
    for (std::size_t i = 0; i < topology_.actuators.size(); ++i) {
      const int actuator = static_cast<int>(i);
      const bool is_named = std::ranges::find(which.inputs, actuator) != which.inputs.end() ||
                            std::ranges::find(which.outputs, actuator) != which.outputs.end();
      double& size = is_named ? largest : beside;
      size = std::max(size, std::abs(of_actuator(i).value));
    }
    for (std::size_t i = 0; i < which.loads.size(); ++i) {
      const bool is_named = std::ranges::count(which.input_loads, i) > 0 ||
                            std::ranges::count(which.output_loads, i) > 0;
      double& size = is_named ? largest : beside;
      size = std::max(size, std::abs(of_load(i).value));
    }
    return beside <= kPowerBalance * largest;
  }

  // What friction leaves of the power, if it leaves any.
  Found efficiency() const {
    const Case& which = values_.which();
    if (values_.friction_count() == 0 || !which.names_both_ends() ||
        !is_between_inputs_and_outputs()) {
      return std::nullopt;
    }
    const Dual in = sum_of(which.inputs, which.input_loads);
    const Dual out = sum_of(which.outputs, which.output_loads);
    return in.value > 0.0 && out.value <= 0.0
               ? quotient(-out, QuantityKind::power, in, QuantityKind::power)
               : std::nullopt;
  }

  const DualCase& values_;
  const Topology& topology_;
};

}  // namespace

Found find_power_value(const DualCase& values, const PathParts& parts) {
  const PowerFormula formula(values);
  return formula.exists() ? formula.find(parts) : std::nullopt;
}

}  // namespace kinestat
