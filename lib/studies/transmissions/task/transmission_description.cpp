#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "files/output.hpp"
#include "report/number_format.hpp"
#include "studies/transmissions/task/transmission_files.hpp"

namespace kinestat {

namespace {

Value parsed(const std::string& text) {
  auto result = parse_expression(text);
  KINESTAT_EXPECTS(std::holds_alternative<Expression>(result));
  return {.expression = std::get<Expression>(std::move(result)), .where = {}, .text_column = 0};
}

Name named(std::string_view text) {
  return {.text = std::string(text), .where = {}};
}

std::vector<Name> all_named(const std::vector<std::string>& texts) {
  std::vector<Name> names;
  for (const std::string& text : texts) {
    names.push_back(named(text));
  }
  return names;
}

// A transmission as it is drawn.
class TransmissionDrawing {
 public:
  TransmissionDrawing(const TransmissionAnalysis& analysis, const TransmissionVariant& variant)
      : task_(analysis.task), variant_(variant) {
    const MechanismDescription& asked = analysis.description;
    result_.name =
        (asked.name.empty() ? report_stem(analysis.file) : asked.name) + ", transmission";
    result_.source = asked.source;
    result_.space = Space::planar;
    result_.units = asked.units;
  }

  MechanismDescription run() {
    result_.parameters = {parameter("speed", "1000 rpm"), parameter("torque", "100 N*m")};
    result_.gears.emplace();
    result_.gears->module = parsed("1.5 mm");
    result_.losses.emplace();
    add_shafts();
    for (std::size_t s = 0; s < variant_.sets.size(); ++s) {
      add_set(s);
    }
    for (std::size_t j = 0; j < variant_.found.elements.size(); ++j) {
      add_element(j);
    }
    if (result_.losses->meshes.empty()) {
      result_.losses.reset();
    }
    result_.actuators = {actuator("in", shaft_joint(kInput)),
                         actuator("out", shaft_joint(kOutput))};
    add_shift();
    return std::move(result_);
  }

 private:
  static ParameterDescription parameter(std::string_view name, const std::string& value) {
    ParameterDescription one;
    one.name = named(name);
    one.value = parsed(value);
    return one;
  }

  static ActuatorDescription actuator(std::string_view name, const std::string& coupling) {
    return {.name = named(name), .coupling = named(coupling), .freedom = std::nullopt};
  }

  // I, O, W3, …: where a shaft turns in the housing.
  static std::string shaft_joint(Shaft shaft) {
    return shaft == kInput ? "I" : shaft == kOutput ? "O" : fmt::format("W{}", shaft);
  }

  void add_body(const std::string& name) {
    result_.bodies.emplace_back();
    result_.bodies.back().name = named(name);
  }

  CouplingDescription& add_coupling(const std::string& name,
                                    CouplingType type,
                                    const std::string& tail,
                                    const std::string& head) {
    CouplingDescription& coupling = result_.couplings.emplace_back();
    coupling.name = named(name);
    coupling.type = type;
    coupling.tail = named(tail);
    coupling.head = named(head);
    return coupling;
  }

  // A shaft on which no gear and no carrier stands has its place from here.
  void add_shafts() {
    result_.ground = named(shaft_name(kHousing));
    for (int i = kInput; i < variant_.shafts; ++i) {
      const auto shaft = static_cast<Shaft>(i);
      add_body(shaft_name(shaft));
      CouplingDescription& joint = add_coupling(
          shaft_joint(shaft), CouplingType::revolute, shaft_name(kHousing), shaft_name(shaft));
      if (!has_set(shaft)) {
        joint.at.emplace();
        joint.at->point.emplace();
        joint.at->point->coordinates = {parsed("0"), parsed("0")};
      }
    }
  }

  bool has_set(Shaft shaft) const {
    for (const SetShafts& set : variant_.sets) {
      if (set[0] == shaft || set[1] == shaft || set[2] == shaft) {
        return true;
      }
    }
    return false;
  }

  // What a set is made of, with its number behind each name.
  struct SetParts {
    std::string number;
    std::string carrier;
    std::string efficiency;  // of each mesh; empty: it loses nothing
  };

  void add_set(std::size_t s) {
    const auto set = static_cast<int>(s);
    const SetRoles roles = set_roles(variant_.found.roles.roles_of(set));
    const SetKind kind = variant_.found.roles.kind_of(set);
    const SetShafts& shafts = variant_.sets[s];
    const SetTeeth& teeth = variant_.teeth[s];
    const double loss = task_.losses[static_cast<std::size_t>(kind)];
    const bool is_simple = kind == SetKind::simple;
    const SetParts parts{
        .number = fmt::format("{}", s + 1),
        .carrier = shaft_name(shafts[roles.carrier]),
        .efficiency = loss > 0.0
                          ? fmt::format("{}^(1/{})", format_exact(1.0 - loss), is_simple ? 2 : 3)
                          : ""};
    const std::string sun = "sun" + parts.number;
    const std::string ring = "ring" + parts.number;
    const std::string inner = (is_simple ? "planet" : "inner") + parts.number;
    const std::string outer = is_simple ? inner : "outer" + parts.number;
    add_member(sun, shaft_name(shafts[roles.sun]), teeth.sun);
    add_planet(parts, "P", inner, teeth);
    if (!is_simple) {
      add_planet(parts, "Q", outer, teeth);
    }
    add_member(ring, shaft_name(shafts[roles.ring]), teeth.ring).internal = true;
    add_mesh(parts, "s", sun, inner);
    if (!is_simple) {
      add_mesh(parts, "p", inner, outer);
    }
    add_mesh(parts, "r", ring, outer);
  }

  GearMember& add_member(const std::string& name, const std::string& body, int teeth) {
    GearMember& member = result_.gears->members.emplace_back();
    member.name = named(name);
    member.body = named(body);
    member.teeth = parsed(fmt::format("{}", teeth));
    return member;
  }

  void add_planet(const SetParts& parts,
                  std::string_view joint,
                  const std::string& name,
                  const SetTeeth& teeth) {
    add_body(name);
    add_coupling(
        fmt::format("{}{}", joint, parts.number), CouplingType::revolute, parts.carrier, name);
    add_member(name, name, teeth.planet).count = parsed(fmt::format("{}", teeth.planets));
  }

  void add_mesh(const SetParts& parts,
                std::string_view kind,
                const std::string& first,
                const std::string& second) {
    MeshDescription& mesh = result_.gears->meshes.emplace_back();
    mesh.name = named(fmt::format("{}{}", kind, parts.number));
    mesh.first = named(first);
    mesh.second = named(second);
    mesh.carrier = named(parts.carrier);
    if (!parts.efficiency.empty()) {
      result_.losses->meshes.push_back(
          {.coupling = mesh.name,
           .loss = {.form = LossForm::efficiency, .value = parsed(parts.efficiency)}});
    }
  }

  void add_element(std::size_t j) {
    const ShaftPair& pair = variant_.found.elements[j];
    add_coupling(element_letter(j),
                 pair[0] == kHousing ? CouplingType::brake : CouplingType::clutch,
                 shaft_name(pair[0]),
                 shaft_name(pair[1]));
  }

  void add_shift() {
    ShiftDescription& shift = result_.shift.emplace();
    shift.inputs = {named("in")};
    shift.outputs = {named("out")};
    shift.input_motion = {{.target = std::nullopt, .value = parsed("speed")}};
    shift.input_action = {{.target = std::nullopt, .value = parsed("torque")}};
    shift.forward = ForwardRatios::positive;
    const std::size_t count = variant_.found.elements.size();
    std::vector<std::string> letters;
    for (std::size_t j = 0; j < count; ++j) {
      letters.push_back(element_letter(j));
    }
    shift.elements = all_named(letters);
    for (const LadderGear& gear : variant_.gears) {
      std::vector<std::string> engaged;
      for (std::size_t j = 0; j < count; ++j) {
        if ((gear.engaged >> j & 1U) != 0) {
          engaged.push_back(letters[j]);
        }
      }
      shift.names.push_back({.label = named(gear.label), .elements = all_named(engaged)});
    }
  }

  const TransmissionTask& task_;
  const TransmissionVariant& variant_;
  MechanismDescription result_;
};

}  // namespace

MechanismDescription describe_transmission(const TransmissionAnalysis& analysis,
                                           const TransmissionVariant& variant) {
  return TransmissionDrawing(analysis, variant).run();
}

}  // namespace kinestat
