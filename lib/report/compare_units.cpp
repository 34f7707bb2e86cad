#include "report/compare_units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "report/compare_place.hpp"

namespace kinestat {

namespace {

enum class Rule {
  length,
  angle,
  angular,
  linear,
  twist,
  moment,
  force,
  wrench,
  power,
  rate,
  action,
  lossy_action,
  ratio,
  affine,
  stated,
  event_drive,
  first_drive,
  column,
  parameter,
  count,
  direction,
  efficiency,
  bare
};

// The first that fits decides.
constexpr auto kRules = std::to_array<std::pair<std::string_view, Rule>>({
    {"/mechanism/parameters/*/value", Rule::parameter},
    {"/graph/bodies/*/reference", Rule::length},
    {"/graph/couplings/*/at", Rule::length},
    {"/mobility", Rule::count},
    {"/cases/*/ratio", Rule::ratio},
    {"/cases/*/torque_ratio", Rule::ratio},
    {"/cases/*/kinematics/order", Rule::count},
    {"/cases/*/kinematics/net_freedom", Rule::count},
    {"/cases/*/kinematics/freedoms/*", Rule::rate},
    {"/cases/*/kinematics/bodies/*/twist/*", Rule::twist},
    {"/cases/*/kinematics/bodies/*/angular", Rule::angular},
    {"/cases/*/kinematics/bodies/*/linear", Rule::linear},
    {"/cases/*/statics/order", Rule::count},
    {"/cases/*/statics/net_constraint", Rule::count},
    {"/cases/*/statics/actions/*", Rule::action},
    {"/cases/*/statics/couplings/*/wrench/*", Rule::wrench},
    {"/cases/*/statics/loads/*/wrench/*", Rule::wrench},
    {"/cases/*/statics/loads/*/moment", Rule::moment},
    {"/cases/*/statics/loads/*/force", Rule::force},
    {"/cases/*/statics/couplings/*/moment", Rule::moment},
    {"/cases/*/statics/couplings/*/force", Rule::force},
    {"/cases/*/statics/planets/*/count", Rule::count},
    {"/cases/*/statics/planets/*/each", Rule::action},
    {"/cases/*/statics/friction/*/couple", Rule::moment},
    {"/cases/*/statics/friction/*/drag", Rule::force},
    {"/cases/*/statics/friction/*/moment", Rule::moment},
    {"/cases/*/statics/friction/*/force", Rule::force},
    {"/cases/*/statics/contacts/*/wrap", Rule::angle},
    {"/cases/*/statics/contacts/*/before", Rule::force},
    {"/cases/*/statics/contacts/*/after", Rule::force},
    {"/cases/*/statics/contacts/*/ratio", Rule::bare},
    {"/cases/*/statics/contacts/*/limit", Rule::bare},
    {"/cases/*/statics/contacts/*/slip_speed", Rule::linear},
    {"/cases/*/statics/contacts/*/slip_power", Rule::power},
    {"/cases/*/*/*/*/at", Rule::length},
    {"/cases/*/*/*/*/screw/direction", Rule::direction},
    {"/cases/*/*/*/*/screw/point", Rule::length},
    {"/cases/*/*/*/*/screw/pitch", Rule::length},
    {"/cases/*/power/efficiency", Rule::efficiency},
    {"/cases/*/power/friction", Rule::power},
    {"/cases/*/power/losses/meshes/*/couple", Rule::moment},
    {"/cases/*/power/losses/meshes/*/power", Rule::power},
    {"/cases/*/power/losses/friction", Rule::power},
    {"/cases/*/power/losses/actuators/*", Rule::lossy_action},
    {"/cases/*/power/couplings", Rule::power},
    {"/cases/*/power/supplied", Rule::power},
    {"/cases/*/power/actuators", Rule::power},
    {"/cases/*/power/loads", Rule::power},
    {"/cases/*/power/arcs", Rule::power},
    {"/cases/*/power/bodies", Rule::power},
    {"/cases/*/power/meshes", Rule::power},
    {"/cases/*/power/recirculation/loops/*/powers", Rule::power},
    {"/cases/*/power/recirculation", Rule::bare},
    {"/cases/*/power/input", Rule::power},
    {"/cases/*/affine/*/*", Rule::affine},
    {"/motion/steps", Rule::count},
    {"/motion/drives/*/*", Rule::stated},
    {"/motion/rows/*/step", Rule::count},
    {"/motion/rows/*/*", Rule::column},
    {"/motion/events/*/step", Rule::count},
    {"/motion/events/*/drive/*", Rule::event_drive},
    {"/motion/events/*/uncertainty", Rule::first_drive},
    {"/motion/assembly/*/*/distance", Rule::length},
    {"/motion/assembly/*/*/shift", Rule::length},
    {"/motion/assembly/*/*/angle", Rule::angle},
    {"/shift/possibilities", Rule::count},
    {"/shift/net_freedom", Rule::count},
    {"/shift/engaged", Rule::count},
    {"/shift/span", Rule::bare},
    {"/shift/states/*/freedom", Rule::count},
    {"/shift/states/*/ratio", Rule::ratio},
    {"/shift/states/*/torque_ratio", Rule::ratio},
    {"/shift/states/*/step", Rule::bare},
    {"/shift/states/*/efficiency", Rule::efficiency},
    {"/shift/states/*/recirculation", Rule::bare},
    {"/shift/states/*/elements/*/torque", Rule::moment},
    {"/shift/states/*/elements/*/slip", Rule::angular},
    {"/shift/states/*/worst_bearing/force", Rule::force},
    {"/shift/states/*/worst_mesh/force", Rule::force},
});

const std::pair<std::string_view, Rule>* find_rule(std::string_view place) {
  const auto at =
      std::ranges::find_if(kRules, [&](const auto& row) { return is_within(place, row.first); });
  return at == kRules.end() ? nullptr : &*at;
}

// The member of an object, or null for what is no object or has no such member.
const Json& member(const Json& value, const char* key) {
  static const Json nothing;
  const auto at = value.find(key);
  return at == value.end() ? nothing : *at;
}

// The first letter of all freedoms, 'w' or 'v', or '?' if they are of both kinds.
char kind_of_freedoms(const Json& freedoms) {
  char kind = 0;
  for (const Json& one : freedoms) {
    const std::string name = one.is_string() ? one.get<std::string>() : "";
    const char letter = name.starts_with('w') || name.starts_with('v') ? name.front() : '?';
    kind = kind == 0 || kind == letter ? letter : '?';
  }
  return kind == 0 ? '?' : kind;
}

// The letter that begins the last part of "a.wz", or 0.
char letter_of(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos || dot + 1 == name.size() ? '\0' : name[dot + 1];
}

bool is_first_half(std::string_view index) {
  return index.size() == 1 && index.front() < '3';
}

}  // namespace

std::optional<ReportUnits> ReportUnits::read(const Json& report, std::string& problem) {
  ReportUnits result;
  for (const auto& wrong : {result.read_file_units(report), result.read_parameters(report)}) {
    if (wrong) {
      problem = *wrong;
      return {};
    }
  }
  result.read_couplings(report);
  result.read_motion(report);
  return result;
}

std::optional<std::string> ReportUnits::read_file_units(const Json& report) {
  const Json& units = member(member(report, "mechanism"), "units");
  for (const QuantityKind kind : all_quantity_kinds()) {
    if (key_of(kind).empty()) {
      continue;
    }
    const Json& text = member(units, std::string(key_of(kind)).c_str());
    if (!text.is_string()) {
      return fmt::format("there is no unit at /mechanism/units/{}", key_of(kind));
    }
    if (const auto error = units_.set(kind, text.get<std::string>())) {
      return fmt::format("/mechanism/units/{}: {}", key_of(kind), printable(error->message));
    }
  }
  return {};
}

std::optional<std::string> ReportUnits::read_parameters(const Json& report) {
  const Json& parameters = member(member(report, "mechanism"), "parameters");
  for (const auto& [name, parameter] : parameters.items()) {
    const Json& text = member(parameter, "unit");
    auto unit = read_unit(text.is_string() ? text.get<std::string>() : "");
    if (const auto* error = std::get_if<ExpressionError>(&unit)) {
      return fmt::format("{}/unit: {}",
                         printable(place_below("/mechanism/parameters", name)),
                         printable(error->message));
    }
    parameters_[name] = std::get<ValueUnit>(std::move(unit));
  }
  return {};
}

void ReportUnits::read_couplings(const Json& report) {
  for (const Json& coupling : member(member(report, "graph"), "couplings")) {
    const char kind = kind_of_freedoms(member(coupling, "freedoms"));
    for (const Json& actuator : member(coupling, "actuators")) {
      if (actuator.is_string()) {
        actuators_[actuator.get<std::string>()] = kind;
      }
    }
  }
}

// A motion writes the unit of each drive and of each column beside it. One that is no unit is not
// told: then the report is of another program.
void ReportUnits::read_motion(const Json& report) {
  const Json& motion = member(report, "motion");
  const auto unit_of = [this](const Json& one) {
    const Json& text = member(one, "unit");
    const auto unit = read_unit(text.is_string() ? text.get<std::string>() : "?");
    const auto* known = std::get_if<ValueUnit>(&unit);
    return known != nullptr ? *known : unknown();
  };
  for (const Json& drive : member(motion, "drives")) {
    const Json& name = member(drive, "name");
    drives_.emplace_back(name.is_string() ? place_below("", name.get<std::string>()) : "",
                         unit_of(drive));
  }
  for (const Json& column : member(motion, "columns")) {
    const Json& name = member(column, "name");
    columns_[name.is_string() ? place_below("", name.get<std::string>()) : ""] = unit_of(column);
  }
}

ValueUnit ReportUnits::at(std::string_view place) const {
  const auto* row = find_rule(place);
  if (row == nullptr) {
    return unknown();
  }
  const std::vector<std::string_view> keys = keys_of(place);
  switch (row->second) {
    case Rule::length:
      return of(QuantityKind::length);
    case Rule::angle:
      return of(QuantityKind::angle);
    case Rule::angular:
      return of(QuantityKind::angular_velocity);
    case Rule::linear:
      return of(QuantityKind::velocity);
    case Rule::twist:
      return of(is_first_half(keys[6]) ? QuantityKind::angular_velocity : QuantityKind::velocity);
    case Rule::moment:
      return of(QuantityKind::moment);
    case Rule::force:
      return of(QuantityKind::force);
    case Rule::wrench:
      return of(is_first_half(keys[6]) ? QuantityKind::moment : QuantityKind::force);
    case Rule::power:
      return of(QuantityKind::power);
    case Rule::rate:
      return rate(keys[4]);
    case Rule::action:
      return action(keys[4]);
    case Rule::lossy_action:
      return action(keys[5]);
    case Rule::ratio:
      return ratio();
    case Rule::stated:
      return drive(keys[2]);
    case Rule::event_drive:
      return drive_at(keys[4]);
    case Rule::first_drive:
      return drive_at("0");
    case Rule::column:
      return column(keys[3]);
    case Rule::affine:
      return coefficient(keys[3], keys[4]);
    case Rule::parameter:
      return parameter(keys[2]);
    case Rule::count:
      return count_unit();
    case Rule::direction:
      return bare_unit("direction");
    case Rule::efficiency:
      return bare_unit("efficiency");
    case Rule::bare:
      return bare_unit("number");
  }
  return unknown();
}

ValueUnit ReportUnits::of(QuantityKind kind) const {
  ValueUnit unit = std::get<ValueUnit>(read_unit(units_.text(kind)));
  return unit;
}

ValueUnit ReportUnits::unknown() const {
  ValueUnit unit;
  for (const QuantityKind kind : all_quantity_kinds()) {
    unit.assumes += fmt::format("{} ", units_.factor(kind));
  }
  return unit;
}

ValueUnit ReportUnits::rate(std::string_view freedom) const {
  switch (letter_of(freedom)) {
    case 'w':
      return of(QuantityKind::angular_velocity);
    case 'v':
      return of(QuantityKind::velocity);
    default:
      return unknown();
  }
}

// The reaction of a coupling, "a.Rx", "a.Tz" or "rope_1.F", or an actuator.
ValueUnit ReportUnits::action(std::string_view name) const {
  const auto actuator = actuators_.find(name);
  const char kind = actuator == actuators_.end() ? letter_of(name) : actuator->second;
  if (kind == 'T' || kind == 'w') {
    return of(QuantityKind::moment);
  }
  const bool is_force = kind == 'R' || kind == 'F' || kind == 'v';
  return is_force ? of(QuantityKind::force) : unknown();
}

// The ratio of two alike is bare; which two it is of, the report does not tell.
ValueUnit ReportUnits::ratio() const {
  const bool are_alike = std::ranges::all_of(actuators_, [this](const auto& one) {
    return one.second != '?' && one.second == actuators_.begin()->second;
  });
  ValueUnit unit = are_alike ? bare_unit("ratio") : unknown();
  unit.kind = "ratio";
  return unit;
}

ValueUnit ReportUnits::drive(std::string_view name) const {
  const auto at =
      std::ranges::find_if(drives_, [&](const auto& one) { return one.first.substr(1) == name; });
  return at == drives_.end() ? unknown() : at->second;
}

ValueUnit ReportUnits::drive_at(std::string_view index) const {
  std::size_t i = drives_.size();
  std::from_chars(index.data(), index.data() + index.size(), i);
  return i < drives_.size() ? drives_[i].second : unknown();
}

ValueUnit ReportUnits::column(std::string_view name) const {
  const auto at = columns_.find("/" + std::string(name));
  return at == columns_.end() ? unknown() : at->second;
}

ValueUnit ReportUnits::parameter(std::string_view name) const {
  const auto at = parameters_.find(name);
  return at == parameters_.end() ? unknown() : at->second;
}

// Of a magnitude per parameter; "1" is the constant.
ValueUnit ReportUnits::coefficient(std::string_view magnitude, std::string_view name) const {
  const bool is_rate = letter_of(magnitude) == 'w' || letter_of(magnitude) == 'v';
  ValueUnit unit = is_rate ? rate(magnitude) : action(magnitude);
  const ValueUnit per = name == "1" ? ValueUnit{} : parameter(name);
  if (per.text.empty() || !per.assumes.empty()) {
    unit.assumes += per.assumes;
    return unit;
  }
  return {.kind = std::move(unit.kind),
          .text = fmt::format("{}/({})", unit.text, per.text),
          .scale = unit.scale / per.scale,
          .dimension = unit.dimension / per.dimension,
          .assumes = std::move(unit.assumes)};
}

}  // namespace kinestat
