#include "studies/simulation/report/simulation_record.hpp"

#include <algorithm>
#include <array>

#include "core/diagnostic.hpp"
#include "core/index.hpp"
#include "mechanism/label_kind.hpp"
#include "mechanism/springs/spring_quantities.hpp"
#include "report/report_keys.hpp"

namespace kinestat {

namespace {

constexpr std::array<std::string_view, 4> kEndWords = {"complete", "goal", "parted", "stuck"};
constexpr std::array<std::string_view, 10> kEventWords = {"goal",
                                                          "impact",
                                                          "rest",
                                                          "release",
                                                          "stick",
                                                          "slip",
                                                          "cable_slack",
                                                          "contact_pulls",
                                                          "cable_slips",
                                                          "lift_off"};

// A column or an event with the units of the file.
template <class Item>
struct ShownItem {
  const SimulationReportView& of;
  const Item& item;

  const FileUnits& units() const { return of.description.units; }
};

std::optional<double> held_action(const SimulationReportView& v,
                                  const SimulationRow& row,
                                  const ActuatorTopology& actuator) {
  if (row.lacks_accelerations) {
    return std::nullopt;
  }
  const Case& which = v.mechanism.cases.front();
  for (std::size_t a = 0; a < which.actions.size(); ++a) {
    if (which.actions[a].index == actuator.action) {
      return row.actions[a];
    }
  }
  for (std::size_t k = 0; k < v.plan.held.size(); ++k) {
    if (v.plan.held[k].of.freedom == actuator.freedom) {
      return row.held[k];
    }
  }
  return std::nullopt;
}

class ColumnMaker {
 public:
  explicit ColumnMaker(const SimulationReportView& view)
      : v_(view), topology_(view.mechanism.topology) {}

  std::vector<SimulationColumn> run() {
    if (v_.solution.rows.empty()) {
      return {};
    }
    add("", "time", QuantityKind::time, [](const SimulationRow& row) { return row.time; });
    for (int f = 0; f < topology_.freedom_count(); ++f) {
      add_freedom(f);
    }
    add_actions();
    add_springs();
    using enum QuantityKind;
    add("", "energy/kinetic", energy, [](const SimulationRow& row) { return row.kinetic; });
    add("", "energy/potential", energy, [](const SimulationRow& row) { return row.potential; });
    add("", "energy/supplied", energy, [](const SimulationRow& row) { return row.supplied; });
    add("", "energy/lost", energy, [](const SimulationRow& row) { return row.lost; });
    const double first = v_.solution.rows.front().balance().value_or(0.0);
    add("", "energy/error", energy, [first](const SimulationRow& row) {
      const std::optional<double> balance = row.balance();
      return balance ? std::optional(*balance - first) : std::nullopt;
    });
    return std::move(columns_);
  }

 private:
  void add_actions() {
    for (int a = 0; a < topology_.action_count(); ++a) {
      const ActionLabel& label = topology_.actions[at(a)];
      const std::string name = topology_.action_name(a);
      if (label.actuator < 0 && !v_.plan.asks_actions) {
        continue;
      }
      add(name, kActionColumn, action_kind(label.is_couple), [&, a](const SimulationRow& row) {
        return label.actuator < 0 ? row.borne[at(a)]
                                  : held_action(v_, row, topology_.actuators[at(label.actuator)]);
      });
    }
    for (std::size_t i = 0; i < v_.mechanism.frictions.size(); ++i) {
      const CouplingFriction& friction = v_.mechanism.frictions[i];
      const Rubbing rubbing = {.coupling = friction.coupling, .slides = {}, .friction = friction};
      if (rubbing.is_dry() || friction.viscous != 0.0) {
        const CouplingTopology& coupling = topology_.coupling(friction.coupling);
        add(coupling.name,
            kFrictionColumn,
            action_kind(topology_.freedoms[at(coupling.first_freedom)].is_rotation),
            [i](const SimulationRow& row) { return row.friction[i]; });
      }
    }
  }

  void add_springs() {
    for (std::size_t i = 0; i < v_.mechanism.springs.size(); ++i) {
      const Spring& spring = v_.mechanism.springs[i];
      const SpringQuantities& quantities = quantities_of(spring, topology_);
      const auto add_of = [&](const char* quantity,
                              QuantityKind kind,
                              double SpringState::*member) {
        add(std::string(kSpringPrefix) + spring.name,
            quantity,
            kind,
            [=](const SimulationRow& row) {
              return i < row.springs.size() ? std::optional(row.springs[i].*member) : std::nullopt;
            });
      };
      add_of(quantities.position, quantities.position_kind, &SpringState::position);
      add_of(quantities.action, quantities.action_kind, &SpringState::force);
    }
  }

  // What else the freedom of an actuator may be called.
  std::string actuator_of(const std::string& element) const {
    for (const ActuatorTopology& actuator : topology_.actuators) {
      if (topology_.freedom_name(actuator.freedom) == element) {
        return actuator.name;
      }
    }
    return "";
  }

  // Time is in every table; of actions without being asked for those of actuators alone.
  bool is_wanted(const std::string& element, std::string_view quantity) const {
    const SimulationReport& report = v_.plan.report;
    return quantity == "time" || report.is_default ||
           wants(report, element, actuator_of(element), quantity) ||
           (report.action && (quantity == kFrictionColumn || element.starts_with(kSpringPrefix)));
  }

  template <class Read>
  void add(const std::string& element,
           std::string_view quantity,
           QuantityKind kind,
           Read read,
           bool is_coordinate = false) {
    if (!is_wanted(element, quantity)) {
      return;
    }
    SimulationColumn column{
        .element = element, .quantity = std::string(quantity), .kind = kind, .values = {}};
    for (const SimulationRow& row : v_.solution.rows) {
      column.values.emplace_back(read(row));
    }
    column.is_coordinate = is_coordinate;
    columns_.push_back(std::move(column));
  }

  void add_freedom(int freedom) {
    const std::size_t f = at(freedom);
    const bool turns = topology_.freedoms[f].is_rotation;
    const std::string name = topology_.freedom_name(freedom);
    const bool is_coordinate = std::ranges::count(v_.solution.coordinates, freedom) > 0;
    const auto add_of = [&](std::string_view quantity, QuantityKind kind, auto list) {
      if (has_any(v_.solution, list, freedom)) {
        add(
            name,
            quantity,
            kind,
            [f, list](const SimulationRow& row) { return (row.*list)[f]; },
            is_coordinate);
      }
    };
    add_of("position", position_kind(turns), &SimulationRow::positions);
    add_of("velocity", rate_kind(turns), &SimulationRow::rates);
    add_of("acceleration",
           turns ? QuantityKind::angular_acceleration : QuantityKind::acceleration,
           &SimulationRow::rate_rates);
  }

  const SimulationReportView& v_;
  const Topology& topology_;
  std::vector<SimulationColumn> columns_;
};

const Record<ShownItem<SimulationColumn>>& column_record() {
  using View = ShownItem<SimulationColumn>;
  static const Record<View> record("One column.", [](Record<View>& keys) {
    keys.text("name", "Element and quantity, as in a.wz/position.", [](const View& v) {
      return v.item.name();
    });
    keys.text("element",
              "coupling.freedom or actuator; empty for what concerns the whole.",
              [](const View& v) { return v.item.element; });
    keys.text("quantity", "position, velocity, energy/kinetic and so on.", [](const View& v) {
      return v.item.quantity;
    });
    keys.text(
            "unit", "That of the file.", [](const View& v) { return v.units().text(v.item.kind); })
        .not_compared();
  });
  return record;
}

Shape rows_shape() {
  Shape cell = number_shape(ByContext::column, true);
  cell.form = Shape::Form::cell;
  return list_shape(list_shape(std::move(cell)));
}

void write_rows(const SimulationReportView& v, Archive& to) {
  const std::vector<SimulationColumn> columns = simulation_columns(v);
  to.begin_list();
  for (std::size_t r = 0; r < v.solution.rows.size(); ++r) {
    to.begin_list();
    for (const SimulationColumn& column : columns) {
      const std::optional<double>& value = column.values[r];
      to.number(
          value ? std::optional(v.description.units.from_si(column.kind, *value)) : std::nullopt,
          {});
    }
    to.end_list();
  }
  to.end_list();
}

const Record<ShownItem<SimulationEvent>>& event_record() {
  using View = ShownItem<SimulationEvent>;
  static const Record<View> record("One event.", [](Record<View>& keys) {
    keys.word(
        "kind",
        {kEventWords.begin(), kEventWords.end()},
        "goal: a freedom reaches the end condition; impact: it strikes a stop; rest: it stays "
        "there; release: it leaves the stop again; stick: its friction holds it; slip: it no "
        "longer does; cable_slack: a cable would have to push; contact_pulls: surfaces in contact "
        "would have to pull; cable_slips: a cable would slip on a pulley that holds it by "
        "friction; lift_off: the arc of a cable on its pulley becomes zero. The last four end the "
        "simulation.",
        [](const View& v) { return word_of(v.item.kind); });
    keys.text("element",
              "The freedom, as the file names it; of the last four the segment of a cable, the "
              "contact, or cable and pulley.",
              [](const View& v) { return v.item.element; });
    keys.quantity("time",
                  QuantityKind::time,
                  "When; of a rest: after the impacts that would follow each other ever faster.",
                  [](const View& v) { return v.item.time; });
    keys.converted("position",
                   ByContext::beside,
                   "Where, from the drawn position; null for what is no freedom, as is the speed.",
                   [](const View& v) {
                     const QuantityKind kind = position_kind(v.item.is_rotation);
                     return std::pair(v.item.position
                                          ? std::optional(v.units().from_si(kind, *v.item.position))
                                          : std::nullopt,
                                      v.units().text(kind));
                   });
    keys.text("unit",
              "That of the position.",
              [](const View& v) { return v.units().text(position_kind(v.item.is_rotation)); })
        .not_in_tables()
        .not_compared();
    const auto speed = [](const View& v, const std::optional<double>& value) {
      const QuantityKind kind = rate_kind(v.item.is_rotation);
      return std::pair(value ? std::optional(v.units().from_si(kind, *value)) : std::nullopt,
                       v.units().text(kind));
    };
    keys.converted("speed", ByContext::beside, "The speed before.", [speed](const View& v) {
      return speed(v, v.item.speed);
    });
    keys.converted("speed_after",
                   ByContext::beside,
                   "Speed after an impact; null for other events.",
                   [speed](const View& v) { return speed(v, v.item.speed_after); });
    keys.text("speed_unit",
              "That of both speeds.",
              [](const View& v) { return v.units().text(rate_kind(v.item.is_rotation)); })
        .not_in_tables()
        .not_compared();
  });
  return record;
}

const Record<SimulationReportView>& simulation_record() {
  using View = SimulationReportView;
  static const Record<View> record(
      "A simulation: the motion in time that follows from the "
      "forces.",
      [](Record<View>& keys) {
        keys.word(
            "status",
            {kEndWords.begin(), kEndWords.end()},
            "complete: to the end of its time; goal: to an earlier end given in the file; parted: "
            "to where a cable or a contact no longer holds; stuck: it could not continue, and the "
            "rows go as far as it did.",
            [](const View& v) { return word_of(v.solution.end); });
        keys.quantity("time", QuantityKind::time, "When it ended.", [](const View& v) {
          return v.solution.rows.empty() ? std::nullopt
                                         : std::optional(v.solution.rows.back().time);
        });
        keys.names("coordinates",
                   "The freedoms whose positions and speeds are the state at the start; near dead "
                   "points of these, others take their place.",
                   [](const View& v, const EachName& each) {
                     for (const int freedom : v.solution.coordinates) {
                       each(v.mechanism.topology.freedom_name(freedom));
                     }
                   });
        keys.list("columns",
                  column_record(),
                  "What the cells of a row are.",
                  [](const View& v, const Each<ShownItem<SimulationColumn>>& each) {
                    for (const SimulationColumn& one : simulation_columns(v)) {
                      each({.of = v, .item = one});
                    }
                  });
        keys.custom("rows",
                    rows_shape(),
                    "One a step, and one where the simulation ends: one cell a column; null where "
                    "there is no value.",
                    write_rows);
        keys.list("events",
                  event_record(),
                  "Events during the motion, in order.",
                  [](const View& v, const Each<ShownItem<SimulationEvent>>& each) {
                    for (const SimulationEvent& one : v.solution.events) {
                      each({.of = v, .item = one});
                    }
                  });
        keys.quantity(
                "energy_drift",
                QuantityKind::energy,
                "The largest energy of a row that is explained by neither the supplied nor the "
                "lost energy: the integration error.",
                [](const View& v) { return v.solution.energy_drift; })
            .not_compared();
        keys.quantity("energy_scale",
                      QuantityKind::energy,
                      "The largest of the energies beside it.",
                      [](const View& v) { return v.solution.energy_scale; });
        keys.number("closure_error",
                    Bare::number,
                    "The largest of a row, relative to the size of the mechanism.",
                    [](const View& v) { return v.solution.closure_error; })
            .not_compared();
        keys.count("evaluations",
                   "Number of evaluations of the accelerations.",
                   [](const View& v) { return v.solution.evaluations; })
            .not_compared();
        keys.count("integration_steps",
                   "Steps of the integration.",
                   [](const View& v) { return v.solution.integrated; })
            .not_compared();
      });
  return record;
}

}  // namespace

std::string_view word_of(SimulationEnd end) {
  return kEndWords[static_cast<std::size_t>(end)];
}

std::string_view word_of(SimulationEvent::Kind kind) {
  return kEventWords[static_cast<std::size_t>(kind)];
}

std::vector<SimulationColumn> simulation_columns(const SimulationReportView& view) {
  return ColumnMaker(view).run();
}

const Record<SimulationReportView>& simulation_report_record() {
  using View = SimulationReportView;
  static const Record<View> record(
      "What 'kinestat simulate --format json' writes: the motion in time that follows from the "
      "forces.",
      [](Record<View>& keys) {
        add_head(keys);
        keys.part(
            "simulation", simulation_record(), [](const View& v) -> const View& { return v; });
        add_diagnostics(keys);
      });
  return record;
}

}  // namespace kinestat
