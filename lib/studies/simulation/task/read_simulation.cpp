#include "studies/simulation/task/read_simulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "core/index.hpp"
#include "core/simulation_tolerance.hpp"
#include "core/text.hpp"
#include "couplings/kinds.hpp"
#include "description/simulation_report_words.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/label_kind.hpp"
#include "studies/simulation/rubbing.hpp"
#include "studies/simulation/simulation_readings.hpp"
#include "studies/simulation/task/simulation_limits.hpp"

namespace kinestat {

namespace {

class SimulationReader {
 public:
  SimulationReader(const MechanismDescription& description,
                   const Mechanism& mechanism,
                   Diagnostics& found)
      : section_(*description.simulation),
        couplings_(description.couplings),
        mechanism_(mechanism),
        topology_(mechanism.topology),
        evaluator_(make_evaluator(description, found)),
        found_(found) {}

  std::optional<SimulationPlan> read() {
    const int before = found_.error_count();
    plan_.where = section_.where;
    plan_.duration = number(section_.time, QuantityKind::time);
    plan_.steps =
        section_.steps
            ? static_cast<int>(std::lround(number(*section_.steps, QuantityKind::dimensionless)))
            : kUsualSteps;
    plan_.tolerance = section_.tolerance ? number(*section_.tolerance, QuantityKind::dimensionless)
                                         : kUsualIntegration;
    read_held();
    read_start();
    read_goals();
    read_stops();
    read_report();
    check_actions();
    check_inertia();
    check_known();
    return found_.error_count() == before ? std::optional(std::move(plan_)) : std::nullopt;
  }

 private:
  double number(const Value& value, QuantityKind kind) {
    return evaluator_.number(value, kind).value_or(0.0);
  }

  bool turns(int freedom) const { return topology_.freedoms[at(freedom)].is_rotation; }

  // An actuator, or coupling.freedom.
  std::optional<NamedFreedom> freedom(const Name& name) {
    for (const ActuatorTopology& actuator : topology_.actuators) {
      if (actuator.name == name.text) {
        return NamedFreedom{.freedom = actuator.freedom, .name = name.text, .where = name.where};
      }
    }
    std::vector<std::string> names;
    const std::string owner = name.text.substr(0, name.text.find('.') + 1);
    for (int f = 0; f < topology_.freedom_count(); ++f) {
      if (topology_.freedom_name(f) == name.text) {
        return NamedFreedom{.freedom = f, .name = name.text, .where = name.where};
      }
      if (topology_.freedom_name(f).starts_with(owner)) {
        names.push_back(topology_.freedom_name(f));
      }
    }
    found_.error("E0313",
                 name.where,
                 fmt::format("'{}' is not the motion of a coupling", name.text),
                 names.empty() ? "name an actuator, or a freedom as COUPLING.FREEDOM"
                               : fmt::format("write {}", fmt::join(names, " or ")));
    return std::nullopt;
  }

  void read_held() {
    for (const Primary& known : mechanism_.cases.front().motions) {
      plan_.held.push_back(
          {.of = {.freedom = known.index, .name = known.given, .where = known.where},
           .speed = known.value});
    }
  }

  bool is_held(int freedom) const {
    return std::ranges::any_of(plan_.held,
                               [&](const HeldFreedom& one) { return one.of.freedom == freedom; });
  }

  void read_start() {
    for (const FreedomState& one : section_.start) {
      const std::optional<NamedFreedom> of = freedom(one.target);
      if (!of) {
        continue;
      }
      const bool is_twice = std::ranges::any_of(plan_.starts, [&](const SimulationStart& other) {
        return other.of.freedom == of->freedom;
      });
      if (is_twice) {
        found_.error("E0517",
                     one.target.where,
                     fmt::format("'{}' of 'start' is given twice", one.target.text),
                     "keep one of the two");
      }
      if (one.speed && is_held(of->freedom)) {
        found_.error(
            "E0517",
            one.target.where,
            fmt::format("'{}' has a speed in 'start', and another in 'motion'", one.target.text),
            "remove one of the two: 'motion' holds the speed all the time");
      }
      plan_.starts.push_back(
          {.of = *of,
           .position =
               one.position ? number(*one.position, position_kind(turns(of->freedom))) : 0.0,
           .speed = one.speed ? number(*one.speed, rate_kind(turns(of->freedom))) : 0.0});
    }
  }

  void read_goals() {
    for (const FreedomState& one : section_.until) {
      const std::optional<NamedFreedom> of = freedom(one.target);
      if (!of) {
        continue;
      }
      if (one.position) {
        plan_.goals.push_back({.of = *of,
                               .is_speed = false,
                               .value = number(*one.position, position_kind(turns(of->freedom)))});
      }
      if (one.speed) {
        plan_.goals.push_back({.of = *of,
                               .is_speed = true,
                               .value = number(*one.speed, rate_kind(turns(of->freedom)))});
      }
    }
  }

  void read_stops() {
    for (const StopDescription& one : section_.stops) {
      const std::optional<NamedFreedom> of = freedom(one.target);
      if (!of) {
        continue;
      }
      if (is_held(of->freedom)) {
        found_.error("E0517",
                     one.target.where,
                     fmt::format("'{}' has a stop, and 'motion' holds it", one.target.text),
                     "remove one of the two: what is held goes on whatever it meets");
        continue;
      }
      const double restitution =
          one.restitution ? number(*one.restitution, QuantityKind::dimensionless) : 0.0;
      const QuantityKind kind = position_kind(turns(of->freedom));
      const double begin = start_of(of->freedom);
      const auto add = [&](const std::optional<Value>& value, double side) {
        if (!value) {
          return;
        }
        const double place = number(*value, kind);
        if (side * (place - begin) < 0.0) {
          found_.error("E0517",
                       one.target.where,
                       fmt::format("'{}' begins beyond its stop", one.target.text),
                       "'from' is its least and 'to' its greatest position, both from the drawn "
                       "one");
        }
        plan_.stops.push_back(
            {.of = *of, .place = place, .side = side, .restitution = restitution});
      };
      if (one.from && one.to && number(*one.from, kind) > number(*one.to, kind)) {
        found_.error("E0517",
                     one.target.where,
                     fmt::format("'from' of the stop of '{}' is above its 'to'", one.target.text),
                     "exchange the two: 'from' is its least and 'to' its greatest position");
        continue;
      }
      add(one.from, -1.0);
      add(one.to, 1.0);
    }
  }

  // Names of what has no column are refused.
  void read_report() {
    SimulationReport& report = plan_.report;
    report.is_default = section_.report.empty();
    const std::vector<SimulationReading> readings = simulation_readings(mechanism_, plan_);
    for (const Name& name : section_.report) {
      if (bool* const word = find_report_word(name.text, report)) {
        *word = true;
        continue;
      }
      report.names.push_back(name.text);
      const auto is_named = [&](const SimulationReading& one) {
        return names_column(name.text, one.element, one.actuator, one.quantity);
      };
      if (std::ranges::none_of(readings, is_named)) {
        found_.error("E0313",
                     name.where,
                     fmt::format("the simulation has no column '{}'", name.text),
                     fmt::format("write {}, or {}",
                                 fmt::join(kSimulationReportWords, ", "),
                                 kSimulationReportNames));
      }
    }
    for (const SimulationReading& one : readings) {
      if (is_wanted(one, report)) {
        plan_.asks_actions = plan_.asks_actions || one.needs_actions;
      }
    }
  }

  double start_of(int freedom) const {
    for (const SimulationStart& one : plan_.starts) {
      if (one.of.freedom == freedom) {
        return one.position;
      }
    }
    return 0.0;
  }

  // Each actuator has an action, unless something holds it.
  void check_actions() {
    const Case& which = mechanism_.cases.front();
    for (const Primary& known : which.actions) {
      const int actuator = topology_.actions[at(known.index)].actuator;
      if (actuator < 0) {
        found_.error(
            "E0518",
            known.where,
            fmt::format("'{}' is borne by a coupling, and follows from the motion", known.given),
            "remove it; what acts from outside is an actuator, a load or a spring");
      } else if (is_held(topology_.actuators[at(actuator)].freedom)) {
        found_.error("E0518",
                     known.where,
                     fmt::format("'{}' has an action, and 'motion' holds it", known.given),
                     "remove one of the two: what holds a motion takes whatever that asks for");
      }
    }
    for (const ActuatorTopology& actuator : topology_.actuators) {
      const bool is_known =
          std::ranges::find(which.actions, actuator.action, &Primary::index) != which.actions.end();
      if (!is_known && !is_held(actuator.freedom)) {
        found_.error(
            "E0518",
            plan_.where,
            fmt::format("'simulation' does not say what actuator '{}' does", actuator.name),
            fmt::format("add action: {{{0}: 0}} if nothing drives it, or what does; "
                        "motion: {{{0}: …}} keeps it at a speed",
                        actuator.name));
      }
    }
  }

  void check_inertia() {
    if (!std::ranges::any_of(mechanism_.masses, &BodyMass::counts)) {
      found_.error("E0518",
                   plan_.where,
                   "no body has mass or inertia, so that nothing says how fast it speeds up",
                   "add 'mass', 'centre_of_mass' and 'inertia' to the bodies that move");
    }
  }

  void check_known() {
    using enum SimulationLimit;
    for (const CouplingFriction& friction : mechanism_.frictions) {
      const CouplingTopology& coupling = topology_.coupling(friction.coupling);
      if (friction.converter) {
        refuse(converter, friction.where, fmt::format("'{}'", coupling.name), found_);
      } else if (coupling.freedom_count != 1) {
        refuse(friction_of_several, friction.where, fmt::format("'{}'", coupling.name), found_);
      }
    }
    for (const LossyMesh& mesh : mechanism_.lossy_meshes) {
      const CouplingTopology& coupling = topology_.coupling(mesh.coupling);
      const std::string name = fmt::format("mesh '{}'", coupling.name);
      if (mesh.law && std::ranges::count(mesh.law->names(), kForceOfTeeth) > 0) {
        refuse(loss_by_force, coupling.where, name, found_);
      } else if ((mesh.law || mesh.share > 0.0) && !turns_on_carrier(mechanism_, mesh)) {
        refuse(loss_without_hinges, coupling.where, name, found_);
      }
    }
    for (const CouplingDescription& coupling : couplings_) {
      if (coupling.one_way) {
        refuse(freewheel, coupling.name.where, fmt::format("'{}'", coupling.name.text), found_);
      }
    }
    for (const ActuatorTopology& actuator : topology_.actuators) {
      const CouplingId id = topology_.freedoms[at(actuator.freedom)].coupling;
      const CouplingTopology& coupling = topology_.coupling(id);
      if (kind_of(coupling.type).only_pushes || coupling.bears_tension()) {
        refuse(contact_actuator, actuator.where, fmt::format("'{}'", actuator.name), found_);
      }
    }
  }

  const SimulationDescription& section_;
  const std::vector<CouplingDescription>& couplings_;
  const Mechanism& mechanism_;
  const Topology& topology_;
  Evaluator evaluator_;
  Diagnostics& found_;
  SimulationPlan plan_;
};

}  // namespace

MechanismDescription simulated_description(const MechanismDescription& description) {
  MechanismDescription result = description;
  result.cases = {case_of(*description.simulation)};
  result.simulation.reset();
  result.shift.reset();
  result.duty.reset();
  result.motion.reset();
  result.dynamics.reset();
  result.sweep.reset();
  result.synthesis.reset();
  result.published.clear();
  return result;
}

std::optional<SimulationPlan> read_simulation(const MechanismDescription& description,
                                              const Mechanism& mechanism,
                                              Diagnostics& found) {
  return SimulationReader(description, mechanism, found).read();
}

}  // namespace kinestat
