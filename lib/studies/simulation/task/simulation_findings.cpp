#include "studies/simulation/task/simulation_findings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cases/findings/action_findings.hpp"
#include "cases/findings/load_findings.hpp"
#include "core/index.hpp"
#include "core/simulation_tolerance.hpp"
#include "core/text.hpp"
#include "dynamics/spring_obstacle_text.hpp"
#include "mechanism/label_kind.hpp"
#include "mechanism/motion_column_names.hpp"
#include "report/number_format.hpp"

namespace kinestat {

namespace {

std::string name_of(const SimulationObstacle& obstacle,
                    const Mechanism& mechanism,
                    const FileUnits& units) {
  using enum SimulationObstacle::Kind;
  const std::string rubbing =
      obstacle.coupling ? fmt::format("'{}'", mechanism.topology.coupling(*obstacle.coupling).name)
                        : "couplings that stick";
  switch (obstacle.kind) {
    case no_branch:
    case singular:
      return "the mechanism stands in a singular position there, from which nothing says how it "
             "goes on";
    case no_inertia:
      return "something moves there that has neither mass nor inertia";
    case rotor:
      return fmt::format(
          "body '{}', of which only the inertia about one axis is known, turns about "
          "another",
          mechanism.topology.body(*obstacle.body).name);
    case spring:
      return text_of(*obstacle.of_spring, mechanism.springs[obstacle.of_spring->spring], units);
    case curve: {
      const CurveObstacle& one = *obstacle.of_curve;
      if (one.kind == CurveObstacle::Kind::no_value) {
        return fmt::format("'{}' has no value there", one.number);
      }
      const Curve& curve = mechanism.curves[one.curve];
      return one.kind == CurveObstacle::Kind::outside
                 ? fmt::format(
                       "it is beyond curve '{}', which goes {}", curve.name, reach_of(curve, units))
                 : fmt::format("curve '{}' has no value there", curve.name);
    }
    case friction_without_end:
      return fmt::format("friction of {} grows without end with what it causes", rubbing);
    case friction_in_two_ways:
      return fmt::format("friction of {} is in balance in two ways", rubbing);
    case no_loss:
      return fmt::format("the loss of mesh {} has no value there from 0 to below 1", rubbing);
    case open_friction:
      return fmt::format("nothing says how large the friction of {} is", rubbing);
    case stuck_in_circuit:
      return fmt::format("{} would stick alone while its circuit moves on", rubbing);
    case beyond_stop:
      return "a freedom begins beyond its stop";
    case no_progress:
      return "stops are struck again and again there, and nothing moves on";
    case no_step:
      return "the steps of the integration vanish there";
    case too_many_steps:
      return "it has come there only after two million accelerations; so fast is something against "
             "'time'";
  }
  return "";
}

std::string_view hint_of(const SimulationObstacle& obstacle) {
  using enum SimulationObstacle::Kind;
  switch (obstacle.kind) {
    case no_branch:
    case singular:
      return "'stops' keep a freedom from going so far; end it before with 'until'";
    case no_inertia:
      return "give the bodies that move 'mass', 'centre_of_mass' and 'inertia'";
    case rotor:
      return "give three moments of inertia instead of {polar: …}";
    case spring:
      return "'kinestat explain E0324' says when; 'stops' keep a freedom from going so far";
    case curve:
      return "give the curve points as far, or a 'period'; 'kinestat explain E0326' says more";
    case friction_without_end:
    case friction_in_two_ways:
      return "rigid bodies with so much friction have no answer there (Painleve): make it less, or "
             "what presses longer";
    case no_loss:
      return "write an expression of 'speed' that has one at any speed, for example by min(0.5, …)";
    case open_friction:
      return "equilibrium leaves open what presses there, or how couplings that stick together "
             "share: leave to each what it takes, or the friction to one of them";
    case stuck_in_circuit:
      return "couplings of a circuit that all rub can stick one by one in some orders only: leave "
             "out the friction of one of them";
    case beyond_stop:
      return "give it a place within, or a stop further out: both are from the drawn position";
    case no_progress:
      return "stops that press on each other through what they stop are not told apart: leave one "
             "of them";
    case no_step:
      return "something becomes infinitely fast there; end it before with 'until'";
    case too_many_steps:
      return "make the time shorter, what is stiff softer or what moves there heavier, or raise "
             "'tolerance'";
  }
  return "";
}

std::optional<double> value_in(const SimulationRow& row, const SimulationGoal& goal) {
  return goal.is_speed ? row.rates[at(goal.of.freedom)] : row.positions[at(goal.of.freedom)];
}

bool starts_at(const SimulationGoal& goal, const SimulationSolution& of) {
  return !of.rows.empty() && value_in(of.rows.front(), goal) == goal.value;
}

// How near a simulation came to a goal that lies beyond all of its rows.
struct NearestRow {
  bool is_greatest = true;
  double value = 0.0;
  double time = 0.0;
};

std::optional<NearestRow> nearest_row(const SimulationGoal& goal, const SimulationSolution& of) {
  std::optional<NearestRow> nearest;
  for (const SimulationRow& row : of.rows) {
    const std::optional<double> value = value_in(row, goal);
    if (!value) {
      continue;
    }
    if (*value == goal.value) {
      return std::nullopt;
    }
    const bool is_below = *value < goal.value;
    if (nearest && nearest->is_greatest != is_below) {
      return std::nullopt;  // rows on both sides of it
    }
    if (!nearest || std::abs(*value - goal.value) < std::abs(nearest->value - goal.value)) {
      nearest = {.is_greatest = is_below, .value = *value, .time = row.time};
    }
  }
  return nearest;
}

void warn_of_missed_goals(const FoundSimulation& simulation,
                          const FileUnits& units,
                          Diagnostics& found) {
  const auto with_unit = [&](QuantityKind kind, double si) {
    return fmt::format("{} {}", format_short(units.from_si(kind, si)), units.text(kind));
  };
  for (const SimulationGoal& goal : simulation.plan.goals) {
    const bool turns = simulation.mechanism.topology.freedoms[at(goal.of.freedom)].is_rotation;
    const QuantityKind kind = goal.is_speed ? rate_kind(turns) : position_kind(turns);
    const std::optional<NearestRow> nearest = nearest_row(goal, simulation.solution);
    found.warning(
        "W0513",
        goal.of.where,
        fmt::format("'{}' {} {} in {}{}",
                    goal.of.name,
                    starts_at(goal, simulation.solution) ? "starts at and does not come back to"
                                                         : "did not reach",
                    with_unit(kind, goal.value),
                    with_unit(QuantityKind::time, simulation.plan.duration),
                    nearest ? fmt::format(": {} of the rows {} at {}",
                                          nearest->is_greatest ? "greatest" : "least",
                                          with_unit(kind, nearest->value),
                                          with_unit(QuantityKind::time, nearest->time))
                            : ""),
        "raise 'time' if it is still on its way; else change the value, or what drives it");
  }
}

void warn_of_energy(const FoundSimulation& simulation, const FileUnits& units, Diagnostics& found) {
  const SimulationSolution& solution = simulation.solution;
  const auto energy = [&](double joules) {
    return fmt::format("{} {}",
                       format_short(units.from_si(QuantityKind::energy, joules)),
                       units.text(QuantityKind::energy));
  };
  if (solution.energy_drift > kEnergyMissed * solution.energy_scale) {
    found.warning("W0515",
                  simulation.plan.where,
                  fmt::format("nothing explains {} of the {} that the simulation exchanges",
                              energy(solution.energy_drift),
                              energy(solution.energy_scale)),
                  "give a smaller 'tolerance', or more 'steps' if something acts for a moment "
                  "only");
  }
}

// Whether a name of the report means a column that there is, or none of a freedom at all.
bool has_column(const std::string& name, const FoundSimulation& simulation) {
  const std::pair<std::string_view, std::vector<std::optional<double>> SimulationRow::*> lists[] = {
      {"position", &SimulationRow::positions},
      {"velocity", &SimulationRow::rates},
      {"acceleration", &SimulationRow::rate_rates}};
  const Topology& topology = simulation.mechanism.topology;
  bool is_of_freedom = false;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    const auto actuator = std::ranges::find(topology.actuators, f, &ActuatorTopology::freedom);
    const std::string also = actuator == topology.actuators.end() ? "" : actuator->name;
    for (const auto& [quantity, list] : lists) {
      if (names_column(name, topology.freedom_name(f), also, quantity)) {
        is_of_freedom = true;
        if (has_any(simulation.solution, list, f)) {
          return true;
        }
      }
    }
  }
  for (int a = 0; a < topology.action_count(); ++a) {
    is_of_freedom =
        is_of_freedom && !names_column(name, topology.action_name(a), "", kActionColumn);
  }
  return !is_of_freedom;
}

void refuse_absent_columns(const FoundSimulation& simulation, Diagnostics& found) {
  for (const std::string& name : simulation.plan.report.names) {
    if (!simulation.solution.rows.empty() && !has_column(name, simulation)) {
      found.error("E0313",
                  simulation.plan.where,
                  fmt::format("the simulation has no column '{}'", name),
                  "freedoms of contacts, cables and balls have velocities, but no positions");
    }
  }
}

// Cables and contacts whose force equilibrium leaves open.
void warn_of_unchecked(const FoundSimulation& simulation, Diagnostics& found) {
  std::vector<std::string> names;
  for (const CouplingId id : simulation.solution.unchecked) {
    names.push_back(fmt::format("'{}'", simulation.mechanism.topology.coupling(id).name));
  }
  if (!names.empty()) {
    found.warning("W0601",
                  simulation.plan.where,
                  fmt::format("equilibrium leaves open what {} bear{}, and the simulation assumes "
                              "that {} hold{}",
                              plain_list(names),
                              names.size() == 1 ? "s" : "",
                              names.size() == 1 ? "it" : "they",
                              names.size() == 1 ? "s" : ""),
                  "enough pretension keeps cables taut; 'kinestat motion' finds the forces for a "
                  "given one");
  }
}

// Reactions that press, but of which no friction comes.
void warn_of_ignored(const FoundSimulation& simulation,
                     const FileUnits& units,
                     Diagnostics& found) {
  for (const IgnoredReaction& one : simulation.solution.ignored) {
    const QuantityKind kind =
        one.reaction == Reaction::axial ? QuantityKind::force : QuantityKind::moment;
    const CouplingTopology& coupling = simulation.mechanism.topology.coupling(one.coupling);
    const ReactionWords words = words_of(one.reaction);
    found.warning("W0604",
                  coupling.where,
                  fmt::format("the simulation: friction of '{}' ignores its {} of up to {} {}",
                              coupling.name,
                              words.what,
                              format_short(units.from_si(kind, one.size)),
                              units.text(kind)),
                  fmt::format("give its friction {}", words.key));
  }
}

void warn_of_pulling_teeth(const FoundSimulation& simulation,
                           const MechanismDescription& description,
                           Diagnostics& found) {
  const Topology& topology = simulation.mechanism.topology;
  for (const PullingTeeth& one : simulation.solution.pulling) {
    const CouplingId id = topology.actions[at(one.action)].coupling;
    ToothWords words = words_of_pulling_teeth(description, id, one.force);
    found.warning("W0610",
                  topology.coupling(id).where,
                  fmt::format("the simulation: {}", words.what),
                  std::move(words.hint));
  }
}

// What the integration may be off of the fastest of the rows is no slip.
double least_slip(const SimulationSolution& solution) {
  double fastest = 0.0;
  for (const SimulationRow& row : solution.rows) {
    for (const std::optional<double>& rate : row.rates) {
      fastest = std::max(fastest, std::abs(rate.value_or(0.0)));
    }
  }
  return kLeastSlip * fastest;
}

// Of each, in the row in which it supplies most power.
void warn_of_driving_clutches(const FoundSimulation& simulation,
                              const FileUnits& units,
                              Diagnostics& found) {
  const Topology& topology = simulation.mechanism.topology;
  const std::vector<Primary>& known = simulation.mechanism.cases.front().actions;
  const double least = least_slip(simulation.solution);
  for (std::size_t i = 0; i < known.size(); ++i) {
    const CouplingTopology& coupling =
        topology.coupling(topology.actions[at(known[i].index)].coupling);
    if (coupling.type != CouplingType::clutch && coupling.type != CouplingType::brake) {
      continue;
    }
    double torque = 0.0;
    double slip = 0.0;
    for (const SimulationRow& row : simulation.solution.rows) {
      const double rate = row.rates[at(coupling.first_freedom)].value_or(0.0);
      const bool slips = std::abs(rate) > least;
      if (slips && i < row.actions.size() && row.actions[i] * rate > torque * slip) {
        torque = row.actions[i];
        slip = rate;
      }
    }
    if (torque * slip > 0.0) {
      ClutchWords words = words_of_driving_clutch(coupling.name, torque, slip, units);
      found.warning("W0612",
                    coupling.where,
                    fmt::format("the simulation: {}: {}", words.would, words.how),
                    std::move(words.hint));
    }
  }
}

void warn_of_singular_rows(const FoundSimulation& simulation,
                           const FileUnits& units,
                           Diagnostics& found) {
  const std::vector<SimulationRow>& rows = simulation.solution.rows;
  const auto first = std::ranges::find_if(rows, &SimulationRow::lacks_accelerations);
  const bool is_stuck = simulation.solution.end == SimulationEnd::stuck;  // which says why
  if (first == rows.end() || (is_stuck && first + 1 == rows.end())) {
    return;
  }
  const auto more = std::ranges::count_if(rows, &SimulationRow::lacks_accelerations) - 1;
  found.warning(
      "W0507",
      simulation.plan.where,
      fmt::format("{} are omitted at {} {}{}",
                  first->kinetic ? "accelerations and actions"
                                 : "most speeds, and all accelerations and actions,",
                  format_short(units.from_si(QuantityKind::time, first->time)),
                  units.text(QuantityKind::time),
                  more > 0 ? fmt::format(" and in {} more row{}", more, more > 1 ? "s" : "") : ""),
      "the position is singular, or so near to it that nothing but rounding would be "
      "left; the simulation passes it, and the other rows are complete");
}

void warn_of_parting(const FoundSimulation& simulation,
                     const FileUnits& units,
                     Diagnostics& found) {
  const Mechanism& mechanism = simulation.mechanism;
  const SimulationEvent& event = simulation.solution.events.back();
  const auto warn = [&](SourceRange where, const std::string& what) {
    found.warning("W0514",
                  where,
                  fmt::format("the simulation ends after {} {}: {}",
                              format_short(units.from_si(QuantityKind::time, event.time)),
                              units.text(QuantityKind::time),
                              what),
                  "how it continues is another mechanism, in a file of its own; 'until' ends it "
                  "before, or change what drives, presses or pulls there");
  };
  const auto is_it = [&](const auto& one) { return one.name == event.element; };
  using enum SimulationEvent::Kind;
  if (event.kind == cable_slack || event.kind == contact_pulls) {
    const auto coupling = std::ranges::find_if(mechanism.topology.couplings, is_it);
    warn(coupling->where,
         event.kind == cable_slack
             ? fmt::format("segment '{}' would have to push", event.element)
             : fmt::format("the surfaces of '{}' would have to pull", event.element));
    return;
  }
  const auto contact = std::ranges::find_if(mechanism.contacts, is_it);
  warn(contact->where,
       event.kind == lift_off
           ? fmt::format("the arc of contact of '{}' becomes zero", event.element)
           : fmt::format("the cable would slip in '{}'", event.element));
}

void add_obstacle(const FoundSimulation& simulation, const FileUnits& units, Diagnostics& found) {
  const SimulationSolution& solution = simulation.solution;
  const double time = solution.time;
  const SimulationObstacle::Kind why = solution.obstacle.kind;
  const bool is_painleve = why == SimulationObstacle::Kind::friction_without_end ||
                           why == SimulationObstacle::Kind::friction_in_two_ways;
  found.error(is_painleve ? "E0519" : "E0515",
              simulation.plan.where,
              fmt::format("the simulation cannot go on after {} {}: {}",
                          format_short(units.from_si(QuantityKind::time, time)),
                          units.text(QuantityKind::time),
                          name_of(solution.obstacle, simulation.mechanism, units)),
              std::string(hint_of(solution.obstacle)));
}

}  // namespace

void add_simulation_findings(const FoundSimulation& simulation,
                             const MechanismDescription& description,
                             Diagnostics& found) {
  const FileUnits& units = description.units;
  refuse_absent_columns(simulation, found);
  warn_of_energy(simulation, units, found);
  warn_of_unchecked(simulation, found);
  warn_of_ignored(simulation, units, found);
  warn_of_pulling_teeth(simulation, description, found);
  warn_of_driving_clutches(simulation, units, found);
  warn_of_singular_rows(simulation, units, found);
  switch (simulation.solution.end) {
    case SimulationEnd::complete:
      return warn_of_missed_goals(simulation, units, found);
    case SimulationEnd::goal:
      return;
    case SimulationEnd::parted:
      return warn_of_parting(simulation, units, found);
    case SimulationEnd::stuck:
      return add_obstacle(simulation, units, found);
  }
}

}  // namespace kinestat
