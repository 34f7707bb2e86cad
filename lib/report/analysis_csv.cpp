#include "report/analysis_csv.hpp"

#include <array>
#include <set>
#include <unordered_set>

#include "core/utf8.hpp"
#include "report/csv.hpp"
#include "report/numbers.hpp"
#include "report/shift_csv.hpp"

namespace kinestat {

namespace {

// The cells of a row that its table and place determine.
struct Place {
  std::string label;  ///< of the case
  std::string pass;
  std::string element;
  std::string status;
};

class CsvWriter {
 public:
  CsvWriter(const Analysis& analysis, std::string& text) : analysis_(analysis), text_(text) {
    const Topology& topology = analysis.mechanism.topology;
    for (int a = 0; a < topology.action_count(); ++a) {
      if (!topology.actions[static_cast<std::size_t>(a)].is_couple) {
        forces_.insert(topology.action_name(a));
      }
    }
    for (int f = 0; f < topology.freedom_count(); ++f) {
      if (!topology.freedoms[static_cast<std::size_t>(f)].is_rotation) {
        translations_.insert(topology.freedom_name(f));
      }
    }
  }

  // Writes the numbers of a value and of all that it contains.
  void add(const Place& place, const std::string& quantity, const Json& value) {
    if (value.is_object()) {
      for (const auto& [key, item] : value.items()) {
        add(place, quantity.empty() ? key : quantity + "/" + key, item);
      }
    } else if (value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        add(place, quantity + "/" + std::to_string(i), value[i]);
      }
    } else if (value.is_number() || value.is_null()) {
      row(place, quantity, value);
    }
  }

  /// The couplings of actions, by name.
  std::set<std::string> couplings_of(const std::set<std::string>& actions) const {
    const Topology& topology = analysis_.mechanism.topology;
    std::set<std::string> couplings;
    for (int a = 0; a < topology.action_count(); ++a) {
      if (actions.contains(topology.action_name(a))) {
        const ActionLabel& label = topology.actions[static_cast<std::size_t>(a)];
        couplings.insert(topology.coupling(label.coupling).name);
      }
    }
    return couplings;
  }

 private:
  void row(const Place& place, const std::string& quantity, const Json& value) {
    const std::string number = value.is_null()             ? ""
                               : value.is_number_integer() ? std::to_string(value.get<long>())
                                                           : format_exact(value.get<double>());
    text_ += csv_line(std::array{
        analysis_.mechanism.name.empty() ? printable(analysis_.file) : analysis_.mechanism.name,
        place.label,
        place.pass,
        place.element,
        quantity,
        number,
        unit_of(place, quantity),
        place.status});
  }

  std::string unit_of(const Place& place, const std::string& path) const {
    const FileUnits& units = analysis_.description.units;
    const std::string_view folder = path.starts_with("load/")       ? "load/"
                                    : path.starts_with("friction/") ? "friction/"
                                                                    : "";
    const std::string quantity = path.substr(folder.size());
    const std::string group = quantity.substr(0, quantity.find('/'));
    const char last = quantity.empty() ? ' ' : quantity.back();
    if (place.pass == "power") {
      return power_unit(units, place.element, group, quantity);
    }
    if (group == "rate") {
      return units.text(is_rotation(place.element) ? QuantityKind::angular_velocity
                                                   : QuantityKind::velocity);
    }
    if (path == "planet/count") {
      return "";
    }
    if (group == "action" || group == "planet" || group == "self_stress") {
      return units.text(is_couple(place.element) ? QuantityKind::moment : QuantityKind::force);
    }
    if (group == "twist" || group == "wrench") {
      const bool is_first_half = last < '3';
      return units.text(
          group == "twist"
              ? (is_first_half ? QuantityKind::angular_velocity : QuantityKind::velocity)
              : (is_first_half ? QuantityKind::moment : QuantityKind::force));
    }
    return path.starts_with("contact/") ? contact_unit(units, path)
                                        : simple_unit(units, quantity, group);
  }

  std::string power_unit(const FileUnits& units,
                         const std::string& element,
                         const std::string& group,
                         const std::string& quantity) const {
    if (group == "lossy_action") {
      return units.text(is_couple(element) ? QuantityKind::moment : QuantityKind::force);
    }
    if (quantity == "loss/couple") {
      return units.text(QuantityKind::moment);
    }
    const bool is_share = group == "balance_residual" || group == "losses" ||
                          group == "efficiency" || group == "recirculation";
    return is_share ? "" : units.text(QuantityKind::power);
  }

  static std::string contact_unit(const FileUnits& units, const std::string& path) {
    const std::string quantity = path.substr(path.find('/') + 1);
    if (quantity == "before" || quantity == "after") {
      return units.text(QuantityKind::force);
    }
    if (quantity == "slip_speed" || quantity == "slip_power") {
      return units.text(quantity == "slip_speed" ? QuantityKind::velocity : QuantityKind::power);
    }
    return quantity == "wrap" ? units.text(QuantityKind::angle) : "";
  }

  static std::string simple_unit(const FileUnits& units,
                                 const std::string& quantity,
                                 const std::string& group) {
    if (group == "angular") {
      return units.text(QuantityKind::angular_velocity);
    }
    if (group == "linear") {
      return units.text(QuantityKind::velocity);
    }
    if (group == "moment" || group == "couple") {
      return units.text(QuantityKind::moment);
    }
    if (group == "force" || group == "drag") {
      return units.text(QuantityKind::force);
    }
    const bool is_length =
        group == "at" || quantity.starts_with("screw/point") || quantity.starts_with("screw/pitch");
    return is_length ? units.text(QuantityKind::length) : "";
  }

  bool is_rotation(const std::string& freedom) const { return !translations_.contains(freedom); }

  bool is_couple(const std::string& action) const { return !forces_.contains(action); }

  const Analysis& analysis_;
  std::string& text_;
  std::unordered_set<std::string> translations_;  ///< names of freedoms, only looked up
  std::unordered_set<std::string> forces_;        ///< of actions likewise
};

void add_elements(CsvWriter& writer,
                  Place place,
                  const Json& elements,
                  const std::string& quantity) {
  for (const auto& [name, value] : elements.items()) {
    place.element = name;
    writer.add(place, quantity, value);
  }
}

// Elements whose status is another.
struct Exceptions {
  std::set<std::string> elements;
  std::string status;
};

void add_elements_but(CsvWriter& writer,
                      Place place,
                      const Json& elements,
                      const std::string& quantity,
                      const Exceptions& exceptions) {
  const std::string usual = place.status;
  for (const auto& [name, value] : elements.items()) {
    place.element = name;
    place.status = exceptions.elements.contains(name) ? exceptions.status : usual;
    writer.add(place, quantity, value);
  }
}

void add_elements_if_any(CsvWriter& writer,
                         const Place& place,
                         const Json& pass,
                         const char* section,
                         const std::string& quantity) {
  if (pass.contains(section)) {
    add_elements(writer, place, pass[section], quantity);
  }
}

void add_self_stresses(CsvWriter& writer, const Place& place, const Json& pass) {
  for (std::size_t i = 0; pass.contains("self_stresses") && i < pass["self_stresses"].size(); ++i) {
    add_elements(
        writer, place, pass["self_stresses"][i]["actions"], "self_stress/" + std::to_string(i));
  }
}

// What a contact does is its status.
void add_contacts(CsvWriter& writer, Place place, const Json& pass) {
  for (const auto& [name, contact] : pass["contacts"].items()) {
    place.element = name;
    place.status = contact["grip"];
    writer.add(place, "contact", contact);
  }
}

// The power of an arc stands beside the bodies that it joins, that of a coupling in a circle of
// power beside the number of the circle.
void add_power_graph(CsvWriter& writer, Place place, const Json& pass) {
  for (const auto& [coupling, arc] : pass["arcs"].items()) {
    const auto from = arc["from"].get<std::string>();
    const auto to = arc["to"].get<std::string>();
    place.element = coupling;
    writer.add(place, "arc/" + from + "/" + to, arc["power"]);
  }
  const Json& loops = pass["recirculation"]["loops"];
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (std::size_t k = 0; k < loops[i]["couplings"].size(); ++k) {
      place.element = loops[i]["couplings"][k];
      writer.add(place, "loop/" + std::to_string(i), loops[i]["powers"][k]);
    }
  }
}

// What completes equilibrium has its method as its status.
void add_statics(CsvWriter& writer, const Place& place, const Json& pass) {
  Exceptions completed;
  if (pass.contains("completion")) {
    completed.elements = pass["completion"]["actions"].get<std::set<std::string>>();
    completed.status = pass["completion"]["method"];
  }
  add_elements_but(writer, place, pass["actions"], "action", completed);
  add_self_stresses(writer, place, pass);
  if (pass.contains("planets")) {
    add_elements_but(writer, place, pass["planets"], "planet", completed);
  }
  completed.elements = writer.couplings_of(completed.elements);
  add_elements_but(writer, place, pass["couplings"], "", completed);
  add_elements_if_any(writer, place, pass, "loads", "load");
  add_elements_if_any(writer, place, pass, "friction", "friction");
  if (pass.contains("contacts")) {
    add_contacts(writer, place, pass);
  }
}

void add_efficiency(CsvWriter& writer, const Place& place, const Json& shares) {
  for (const char* model : {"friction", "carrier", "carrier_backward", "absolute"}) {
    if (shares.contains(model)) {
      writer.add(place, std::string("efficiency/") + model, shares[model]);
    }
  }
}

void add_losses(CsvWriter& writer, const Place& place, const Json& losses) {
  add_elements(writer, place, losses["meshes"], "loss");
  add_elements_if_any(writer, place, losses, "friction", "lossy_friction");
  add_elements(writer, place, losses["actuators"], "lossy_action");
  writer.add(place, "losses/balance_residual", losses["balance_residual"]);
}

void add_case(CsvWriter& writer, const Place& place, const Json& pass) {
  if (place.pass == "kinematics") {
    add_elements(writer, place, pass["freedoms"], "rate");
    add_elements(writer, place, pass["bodies"], "");
  } else if (place.pass == "statics") {
    add_statics(writer, place, pass);
  } else {
    add_elements(writer, place, pass["couplings"], "into_head");
    add_elements(writer, place, pass["supplied"], "supplied");
    add_elements(writer, place, pass["actuators"], "actuator");
    add_elements_if_any(writer, place, pass, "loads", "load");
    add_elements_if_any(writer, place, pass, "friction", "friction");
    if (pass.contains("efficiency")) {
      add_efficiency(writer, place, pass["efficiency"]);
    }
    if (pass.contains("losses")) {
      add_losses(writer, place, pass["losses"]);
    }
    add_elements(writer, place, pass["bodies"], "body");
    add_elements_if_any(writer, place, pass, "meshes", "mesh");
    add_power_graph(writer, place, pass);
    writer.add(place, "recirculation/factor", pass["recirculation"]["factor"]);
    writer.add(place, "input", pass["input"]);
    writer.add(place, "balance_residual", pass["balance_residual"]);
  }
}

}  // namespace

std::vector<CsvTable> analysis_csv(const Analysis& analysis, const Json& report) {
  std::vector<CsvTable> tables;
  tables.push_back({.pass = "mobility", .text = std::string(kCsvHeader)});
  CsvWriter mobility(analysis, tables.back().text);
  for (const char* order : {"minimal", "planar", "spatial"}) {
    const Json& counts = report["mobility"][order];
    if (!counts.is_null()) {
      mobility.add(
          {.label = "", .pass = "mobility", .element = order, .status = "solved"}, "", counts);
    }
  }
  for (const char* pass : {"kinematics", "statics", "power"}) {
    CsvTable table{.pass = pass, .text = std::string(kCsvHeader)};
    CsvWriter writer(analysis, table.text);
    bool has_rows = false;
    for (const auto& [label, one] : report["cases"].items()) {
      if (one.contains(pass)) {
        has_rows = true;
        const std::string status = one[pass]["status"];
        add_case(
            writer, {.label = label, .pass = pass, .element = "", .status = status}, one[pass]);
      }
    }
    if (has_rows) {
      tables.push_back(std::move(table));
    }
  }
  if (analysis.shift) {
    tables.push_back({.pass = "shift", .text = shift_csv(analysis, report["shift"])});
  }
  return tables;
}

}  // namespace kinestat
