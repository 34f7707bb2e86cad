#include "studies/simulation/simulation_readings.hpp"

#include <algorithm>
#include <utility>

#include "core/index.hpp"
#include "description/simulation_report_words.hpp"
#include "mechanism/couplings/coupling_reactions.hpp"
#include "mechanism/label_kind.hpp"
#include "mechanism/motion_column_names.hpp"
#include "mechanism/springs/spring_quantities.hpp"

namespace kinestat {

namespace {

using Value = std::optional<double>;

constexpr std::string_view kReactionWord = "reaction";

// What an actuator does: what the file says, or what holds it.
Value actuator_action(const Mechanism& mechanism,
                      const SimulationPlan& plan,
                      const SimulationRow& row,
                      const ActuatorTopology& actuator) {
  if (row.lacks_accelerations) {
    return std::nullopt;
  }
  const Case& which = mechanism.cases.front();
  for (std::size_t a = 0; a < which.actions.size(); ++a) {
    if (which.actions[a].index == actuator.action) {
      return row.actions[a];
    }
  }
  for (std::size_t k = 0; k < plan.held.size(); ++k) {
    if (plan.held[k].of.freedom == actuator.freedom) {
      return row.held[k];
    }
  }
  return std::nullopt;
}

Value product(const Value& a, const Value& b) {
  return a && b ? Value(*a * *b) : std::nullopt;
}

class ReadingMaker {
 public:
  ReadingMaker(const Mechanism& mechanism, const SimulationPlan& plan)
      : mechanism_(mechanism), topology_(mechanism.topology), plan_(plan) {}

  std::vector<SimulationReading> run() {
    SimulationReading& time =
        add({.element = "", .quantity = std::string(kTimeColumn), .kind = QuantityKind::time},
            [](const SimulationRow& row) { return row.time; });
    time.is_always = true;
    time.has_peaks = false;
    for (int f = 0; f < topology_.freedom_count(); ++f) {
      add_freedom(f);
    }
    for (int a = 0; a < topology_.action_count(); ++a) {
      add_action(a);
    }
    add_friction();
    add_reactions();
    add_springs();
    add_powers();
    add_energies();
    return std::move(readings_);
  }

 private:
  template <class Read>
  SimulationReading& add(SimulationReading reading, Read read) {
    reading.value = [read](const SimulationRow& row, const SimulationRow& /*first*/) -> Value {
      return read(row);
    };
    readings_.push_back(std::move(reading));
    return readings_.back();
  }

  void add_freedom(int freedom) {
    const std::size_t f = at(freedom);
    const bool turns = topology_.freedoms[f].is_rotation;
    const auto actuator =
        std::ranges::find(topology_.actuators, freedom, &ActuatorTopology::freedom);
    const auto add_of = [&](std::string_view quantity, QuantityKind kind, auto list) {
      add({.element = topology_.freedom_name(freedom),
           .quantity = std::string(quantity),
           .kind = kind,
           .words = {quantity},
           .actuator = actuator == topology_.actuators.end() ? "" : actuator->name,
           .freedom = freedom},
          [f, list](const SimulationRow& row) { return (row.*list)[f]; });
    };
    add_of("position", position_kind(turns), &SimulationRow::positions);
    add_of("velocity", rate_kind(turns), &SimulationRow::rates);
    add_of("acceleration",
           turns ? QuantityKind::angular_acceleration : QuantityKind::acceleration,
           &SimulationRow::rate_rates);
  }

  void add_action(int action) {
    const ActionLabel& label = topology_.actions[at(action)];
    const bool is_borne = label.actuator < 0;
    SimulationReading& reading = add(
        {.element = topology_.action_name(action),
         .quantity = std::string(kActionColumn),
         .kind = action_kind(label.is_couple),
         .words = {kActionColumn}},
        [this_ = sources(), action, is_borne, actuator = label.actuator](const SimulationRow& row) {
          return is_borne ? value_at(row.borne, at(action))
                          : actuator_action(this_.mechanism,
                                            this_.plan,
                                            row,
                                            this_.mechanism.topology.actuators[at(actuator)]);
        });
    reading.is_usual = !is_borne;
    reading.needs_actions = is_borne;
  }

  // Of tail on head.
  void add_friction() {
    for (std::size_t i = 0; i < mechanism_.frictions.size(); ++i) {
      if (rubs(mechanism_.frictions[i])) {
        const CouplingTopology& coupling = topology_.coupling(mechanism_.frictions[i].coupling);
        add({.element = coupling.name,
             .quantity = std::string(kReactionFriction),
             .kind = action_kind(topology_.freedoms[at(coupling.first_freedom)].is_rotation),
             .words = {kActionColumn, kReactionWord}},
            [i](const SimulationRow& row) { return row.friction[i]; });
      }
    }
  }

  static bool rubs(const CouplingFriction& friction) {
    const Rubbing rubbing = {.coupling = friction.coupling, .slides = {}, .friction = friction};
    return rubbing.is_dry() || friction.viscous != 0.0;
  }

  void add_reactions() {
    const std::vector<CouplingReaction> reactions = coupling_reactions(mechanism_);
    for (std::size_t i = 0; i < reactions.size(); ++i) {
      SimulationReading& force =
          add({.element = topology_.coupling(reactions[i].coupling).name,
               .quantity = std::string(kReactionForce),
               .kind = QuantityKind::force,
               .words = {kReactionWord}},
              [i](const SimulationRow& row) {
                const bool has_one = i < row.reactions.size() && row.reactions[i];
                return has_one ? std::optional(row.reactions[i]->norm()) : std::nullopt;
              });
      force.is_usual = false;
      force.needs_actions = true;
    }
    for (std::size_t i = 0; i < mechanism_.frictions.size(); ++i) {
      if (!rubs(mechanism_.frictions[i])) {
        continue;
      }
      const CouplingTopology& coupling = topology_.coupling(mechanism_.frictions[i].coupling);
      SimulationReading& loss = add({.element = coupling.name,
                                     .quantity = std::string(kReactionLoss),
                                     .kind = QuantityKind::power,
                                     .words = {kReactionWord}},
                                    [i, f = at(coupling.first_freedom)](const SimulationRow& row) {
                                      const Value power = product(row.friction[i], row.rates[f]);
                                      return power ? Value(0.0 - *power) : std::nullopt;
                                    });
      loss.is_usual = false;
    }
  }

  void add_springs() {
    for (std::size_t i = 0; i < mechanism_.springs.size(); ++i) {
      const Spring& spring = mechanism_.springs[i];
      const SpringQuantities& quantities = quantities_of(spring, topology_);
      const auto add_of =
          [&](const char* quantity, QuantityKind kind, double SpringState::*member) {
            add({.element = std::string(kSpringPrefix) + spring.name,
                 .quantity = quantity,
                 .kind = kind,
                 .words = {kActionColumn}},
                [=](const SimulationRow& row) {
                  return i < row.springs.size() ? Value(row.springs[i].*member) : std::nullopt;
                });
          };
      add_of(quantities.position, quantities.position_kind, &SpringState::position);
      add_of(quantities.action, quantities.action_kind, &SpringState::force);
    }
  }

  template <class Read>
  void add_power(std::string element, Read read) {
    add({.element = std::move(element),
         .quantity = std::string(kPowerColumn),
         .kind = QuantityKind::power,
         .words = {kPowerColumn}},
        read)
        .is_usual = false;
  }

  // In the order of a motion: actuators, loads, springs.
  void add_powers() {
    for (const ActuatorTopology& actuator : topology_.actuators) {
      add_power(actuator.name, [this_ = sources(), &actuator](const SimulationRow& row) {
        return product(actuator_action(this_.mechanism, this_.plan, row, actuator),
                       row.rates[at(actuator.freedom)]);
      });
    }
    std::size_t load = 0;
    const auto add_load = [&](const std::string& name) {
      add_power(name,
                [i = load++](const SimulationRow& row) { return value_at(row.load_powers, i); });
    };
    for (const Load& one : mechanism_.cases.front().loads) {
      add_load(one.name);
    }
    for (const MovingLoad& one : mechanism_.cases.front().moving_loads) {
      add_load(one.name);
    }
    for (std::size_t i = 0; i < mechanism_.springs.size(); ++i) {
      const Spring& spring = mechanism_.springs[i];
      add_power(std::string(kSpringPrefix) + spring.name,
                [i, sign = spring.is_of_freedom() ? 1.0 : -1.0](const SimulationRow& row) {
                  return i < row.springs.size()
                             ? Value(0.0 + sign * row.springs[i].force * row.springs[i].rate)
                             : std::nullopt;
                });
    }
  }

  void add_energies() {
    const auto add_of = [&](const char* part, auto read) {
      add({.element = "",
           .quantity = std::string(kEnergyWord) + "/" + part,
           .kind = QuantityKind::energy,
           .words = {kEnergyWord}},
          read);
    };
    add_of("kinetic", [](const SimulationRow& row) { return row.kinetic; });
    add_of("potential", [](const SimulationRow& row) { return row.potential; });
    add_of("supplied", [](const SimulationRow& row) { return row.supplied; });
    add_of("lost", [](const SimulationRow& row) { return row.lost; });
    add_of("error", [](const SimulationRow& /*row*/) { return Value(); });
    readings_.back().value = [](const SimulationRow& row, const SimulationRow& first) -> Value {
      const Value balance = row.balance();
      return balance ? Value(*balance - first.balance().value_or(0.0)) : std::nullopt;
    };
    readings_.back().has_peaks = false;
  }

  static Value value_at(const std::vector<Value>& values, std::size_t i) {
    return i < values.size() ? values[i] : std::nullopt;
  }

  // What readings refer to.
  struct Sources {
    const Mechanism& mechanism;
    const SimulationPlan& plan;
  };

  Sources sources() const { return {.mechanism = mechanism_, .plan = plan_}; }

  const Mechanism& mechanism_;
  const Topology& topology_;
  const SimulationPlan& plan_;
  std::vector<SimulationReading> readings_;
};

}  // namespace

std::vector<SimulationReading> simulation_readings(const Mechanism& mechanism,
                                                   const SimulationPlan& plan) {
  return ReadingMaker(mechanism, plan).run();
}

bool is_wanted(const SimulationReading& reading, const SimulationReport& report) {
  const auto is_asked = [&](std::string_view word) { return asks(report, word); };
  const auto is_named = [&](const std::string& name) {
    return names_column(name, reading.element, reading.actuator, reading.quantity);
  };
  return reading.is_always || (report.is_default && reading.is_usual) ||
         std::ranges::any_of(reading.words, is_asked) ||
         std::ranges::any_of(report.names, is_named);
}

std::vector<SimulationReading> wanted_readings(const Mechanism& mechanism,
                                               const SimulationPlan& plan) {
  std::vector<SimulationReading> readings = simulation_readings(mechanism, plan);
  std::erase_if(readings,
                [&](const SimulationReading& one) { return !is_wanted(one, plan.report); });
  return readings;
}

}  // namespace kinestat
