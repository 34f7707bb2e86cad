#include "studies/simulation/report/simulation_record.hpp"

#include <algorithm>
#include <array>

#include "core/diagnostic.hpp"
#include "mechanism/label_kind.hpp"
#include "report/report_keys.hpp"
#include "studies/simulation/simulation_readings.hpp"

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

std::vector<SimulationColumn> make_columns(const SimulationReportView& v) {
  std::vector<SimulationColumn> columns;
  if (v.solution.rows.empty()) {
    return columns;
  }
  const std::vector<SimulationReading> readings = wanted_readings(v.mechanism, v.plan);
  for (std::size_t c = 0; c < readings.size(); ++c) {
    const SimulationReading& reading = readings[c];
    SimulationColumn column{.element = reading.element,
                            .quantity = reading.quantity,
                            .kind = reading.kind,
                            .reading = c};
    for (const SimulationRow& row : v.solution.rows) {
      column.values.emplace_back(reading.value(row, v.solution.rows.front()));
    }
    const auto has_value = [](const std::optional<double>& one) { return one.has_value(); };
    if (reading.freedom >= 0 && std::ranges::none_of(column.values, has_value)) {
      continue;
    }
    column.is_coordinate = std::ranges::count(v.solution.coordinates, reading.freedom) > 0;
    if (reading.has_peaks) {
      column.extremes = v.solution.extremes[c];
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

const Record<ShownItem<SimulationColumn>>& column_record() {
  using View = ShownItem<SimulationColumn>;
  static const Record<View> record("One column.", [](Record<View>& keys) {
    keys.text("name", "Element and quantity, as in a.wz/position.", [](const View& v) {
      return v.item.name();
    });
    keys.text(
        "element",
        "coupling.freedom, coupling.action, actuator, coupling, load or spring; empty for what "
        "concerns the whole.",
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

const Record<ShownItem<SimulationColumn>>& figures_record() {
  using View = ShownItem<SimulationColumn>;
  using Extreme = std::optional<SimulationExtreme> SimulationExtremes::*;
  static const Record<View> record("One column.", [](Record<View>& keys) {
    keys.text(
            "unit", "That of the file.", [](const View& v) { return v.units().text(v.item.kind); })
        .not_compared();
    const auto add = [&](const char* key, const char* when, Extreme extreme, const char* meaning) {
      keys.converted(key, ByContext::beside, meaning, [extreme](const View& v) {
        const auto& one = (*v.item.extremes).*extreme;
        return std::pair(
            one ? std::optional(v.units().from_si(v.item.kind, one->value)) : std::nullopt,
            v.units().text(v.item.kind));
      });
      keys.quantity(when,
                    QuantityKind::time,
                    "When that is first.",
                    [extreme](const View& v) {
                      const auto& one = (*v.item.extremes).*extreme;
                      return one ? std::optional(one->time) : std::nullopt;
                    })
          .not_compared();
    };
    add("least",
        "least_time",
        &SimulationExtremes::least,
        "The least value, also between the rows; null where the column has no values.");
    add("greatest",
        "greatest_time",
        &SimulationExtremes::greatest,
        "The greatest value, likewise.");
  });
  return record;
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
        keys.map(
            "figures",
            figures_record(),
            "Extremes of each column but the time and the energy that nothing explains, by its "
            "name as in 'columns'.",
            [](const View& v, const Each<ShownItem<SimulationColumn>>& each) {
              for (const SimulationColumn& one : simulation_columns(v)) {
                if (one.extremes) {
                  each(one.name(), {.of = v, .item = one});
                }
              }
            });
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
                      "The largest of the energies beside it, also between rows.",
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
  return make_columns(view);
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
