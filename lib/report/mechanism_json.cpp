#include "report/mechanism_json.hpp"

#include "core/utf8.hpp"
#include "core/version.hpp"
#include "report/in_units.hpp"

namespace kinestat {

namespace {

Json parameters_json(const MechanismDescription& description) {
  const ParameterTable table = evaluate_parameters(parameters_of(description)).table;
  Json result = object_of(description.parameters.size());
  for (const ParameterDescription& parameter : description.parameters) {
    Json entry;
    entry["expression"] = parameter.value.expression.text();
    if (const Quantity* value = table.find(parameter.name.text)) {
      const NamedUnit unit = description.units.unit_of(value->dimension);
      entry["value"] = number(unit.scale.from_si(value->value));
      entry["unit"] = unit.text;
    }
    if (parameter.is_free) {
      entry["free"] = true;
    }
    result[parameter.name.text] = std::move(entry);
  }
  return result;
}

Json mechanism_json(const std::string& file, const MechanismDescription& description) {
  Json result = object_of(8);
  result["name"] = description.name;
  result["source"] = description.source;
  result["file"] = printable(file);
  result["space"] = description.space == Space::planar ? "planar" : "spatial";
  for (const QuantityKind kind : all_quantity_kinds()) {
    if (!key_of(kind).empty()) {
      result["units"][std::string(key_of(kind))] = description.units.text(kind);
    }
  }
  result["parameters"] = parameters_json(description);
  return result;
}

Json coupling_json(const Mechanism& mechanism, std::size_t e, const InUnits& in) {
  const Topology& topology = mechanism.topology;
  const CouplingTopology& coupling = topology.couplings[e];
  Json result = object_of(8);
  result["name"] = coupling.name;
  result["type"] = word_of(coupling.type);
  result["bodies"] = {topology.body(coupling.tail).name, topology.body(coupling.head).name};
  result["at"] = vector(in.length(mechanism.geometry.points[e]));
  result["freedoms"] = Json::array();
  for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count; ++f) {
    result["freedoms"].push_back(topology.freedoms[static_cast<std::size_t>(f)].name);
  }
  result["constraints"] = Json::array();
  result["actuators"] = Json::array();
  for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
    const ActionLabel& action = topology.actions[static_cast<std::size_t>(a)];
    result[action.actuator < 0 ? "constraints" : "actuators"].push_back(action.name);
  }
  return result;
}

Json names(const Topology& topology, const std::vector<int>& edges) {
  Json result = Json::array();
  for (const int e : edges) {
    result.push_back(topology.couplings[static_cast<std::size_t>(e)].name);
  }
  return result;
}

}  // namespace

Json graph_json(const Mechanism& mechanism, const FileUnits& units) {
  const InUnits in(units);
  const Topology& topology = mechanism.topology;
  Json result = object_of(8);
  result["bodies"] = Json::array();
  for (std::size_t b = 0; b < topology.bodies.size(); ++b) {
    Json body;
    body["name"] = topology.bodies[b].name;
    body["reference"] = vector(in.length(mechanism.geometry.references[b]));
    result["bodies"].push_back(std::move(body));
  }
  result["couplings"] = Json::array();
  for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
    result["couplings"].push_back(coupling_json(mechanism, e, in));
  }
  result["tree"] = names(topology, mechanism.graph.tree.branches);
  result["chords"] = names(topology, mechanism.graph.tree.chords);
  return result;
}

Json report_head(const std::string& file, const MechanismDescription& description) {
  Json result = object_of(8);
  result["kinestat"]["version"] = kVersion;
  result["kinestat"]["report"] = kReportVersion;
  result["mechanism"] = mechanism_json(file, description);
  return result;
}

}  // namespace kinestat
