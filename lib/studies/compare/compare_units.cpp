#include "studies/compare/compare_units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "expression/unit_quotient.hpp"
#include "studies/compare/compare_place.hpp"

namespace kinestat {

namespace {

// The member of an object, or null for what is no object or has no such member.
const Json& member(const Json& value, const char* key) {
  static const Json nothing;
  const auto at = value.find(key);
  return at == value.end() ? nothing : *at;
}

// The first letter of a freedom, 'w' or 'v'; '?' of what is none.
char kind_of_freedom(const Json& freedom) {
  const std::string name = freedom.is_string() ? freedom.get<std::string>() : "";
  return name.starts_with('w') || name.starts_with('v') ? name.front() : '?';
}

// That of all freedoms, or '?' if they are of both kinds.
char kind_of_freedoms(const Json& freedoms) {
  char kind = 0;
  for (const Json& one : freedoms) {
    const char letter = kind_of_freedom(one);
    kind = kind == 0 || kind == letter ? letter : '?';
  }
  return kind == 0 ? '?' : kind;
}

// The letter that begins the last part of "a.wz", or 0.
char letter_of(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos || dot + 1 == name.size() ? '\0' : name[dot + 1];
}

// The unit that a text is, or another where it is none.
ValueUnit unit_or(std::string_view text, const ValueUnit& other) {
  auto unit = read_unit(text);
  auto* known = std::get_if<ValueUnit>(&unit);
  return known != nullptr ? std::move(*known) : other;
}

const ValueUnit& bare_unit_of(Bare measure) {
  static const auto units = [] {
    std::map<Bare, ValueUnit> result = {{Bare::count, count_unit()}};
    for (const Bare one : {Bare::number, Bare::ratio, Bare::efficiency, Bare::direction}) {
      result.emplace(one, bare_unit(std::string(word_of(one))));
    }
    return result;
  }();
  return units.at(measure);
}

// Of a magnitude per parameter.
ValueUnit unit_of_coefficient(const ValueUnit& magnitude, const ValueUnit& parameter) {
  ValueUnit unit = magnitude;
  if (parameter.text.empty() || !parameter.assumes.empty()) {
    unit.assumes += parameter.assumes;
    return unit;
  }
  unit.text = unit_quotient(magnitude.text, parameter.text);
  unit.scale = magnitude.scale / parameter.scale;
  unit.dimension = magnitude.dimension / parameter.dimension;
  return unit;
}

// What is made of two units, once.
template <typename Quotients, typename Make>
const ValueUnit& quotient(Quotients& known,
                          const ValueUnit& above,
                          const ValueUnit& below,
                          Make make) {
  const auto [at, is_new] = known.try_emplace({&above, &below});
  if (is_new) {
    at->second = make(above, below);
  }
  return at->second;
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
  result.read_ratios(report);
  result.read_motion(report);
  result.read_synthesis(report);
  return result;
}

std::optional<std::string> ReportUnits::read_file_units(const Json& report) {
  const Json& units = member(member(report, "mechanism"), "units");
  for (const QuantityKind kind : all_quantity_kinds()) {
    if (key_of(kind).empty()) {
      continue;
    }
    const Json& text = member(units, std::string(key_of(kind)).c_str());
    if (text.is_null() && (kind == QuantityKind::energy || kind == QuantityKind::inertia)) {
      continue;  // reports of version 0.1.0 have none
    }
    if (!text.is_string()) {
      return fmt::format("there is no unit at /mechanism/units/{}", key_of(kind));
    }
    if (const auto error = units_.set(kind, text.get<std::string>())) {
      return fmt::format("/mechanism/units/{}: {}", key_of(kind), printable(error->message));
    }
  }
  for (const QuantityKind kind : all_quantity_kinds()) {
    kinds_[static_cast<std::size_t>(kind)] = std::get<ValueUnit>(read_unit(units_.text(kind)));
    unknown_.assumes += fmt::format("{} ", units_.factor(kind));
  }
  per_length_ = unit_or(unit_quotient("", units_.text(QuantityKind::length)), unknown_);
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
    const Json& driven = member(coupling, "driven");
    std::size_t i = 0;
    for (const Json& actuator : member(coupling, "actuators")) {
      if (actuator.is_string()) {
        actuators_[actuator.get<std::string>()] =
            i < driven.size() ? kind_of_freedom(driven[i]) : kind;
      }
      ++i;
    }
  }
  const bool are_alike = std::ranges::all_of(actuators_, [this](const auto& one) {
    return one.second != '?' && one.second == actuators_.begin()->second;
  });
  ratio_ = are_alike ? bare_unit_of(Bare::ratio) : unknown_;
  ratio_.kind = "ratio";
}

// One that is no unit is not reported.
void ReportUnits::read_ratios(const Json& report) {
  const auto read = [this](const Json& text) {
    ValueUnit result = unit_or(text.is_string() ? text.get<std::string>() : "", unknown_);
    result.kind = "ratio";
    return result;
  };
  const Json& shift = member(report, "shift");
  const auto read_all = [&](const char* key, RatioUnits& units) {
    for (const auto& [label, one] : member(report, "cases").items()) {
      units.of_cases[label] = read(member(one, key));
    }
    for (const auto& [output, unit] : member(shift, key).items()) {
      units.of_outputs[output] = read(unit);
    }
  };
  read_all("ratio_unit", rate_ratios_);
  read_all("torque_ratio_unit", action_ratios_);
}

// A motion writes the unit of each drive and of each column beside it, and so does a simulation.
// One that is no unit is not told: then the report is of another program.
void ReportUnits::read_motion(const Json& report) {
  const Json& motion = member(report, "motion");
  for (const Json& drive : member(motion, "drives")) {
    const Json& name = member(drive, "name");
    drives_.emplace_back(name.is_string() ? name.get<std::string>() : "", beside(drive));
  }
  for (const Json* section : {&motion, &member(report, "simulation")}) {
    for (const Json& column : member(*section, "columns")) {
      const Json& name = member(column, "name");
      columns_[name.is_string() ? name.get<std::string>() : ""] = beside(column);
    }
  }
}

void ReportUnits::read_synthesis(const Json& report) {
  const Json& tasks = member(member(report, "synthesis"), "tasks");
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    const Json& dyads = member(tasks[t], "dyads");
    const Json& linkages = member(tasks[t], "linkages");
    for (std::size_t i = 0; i < linkages.size(); ++i) {
      const Json& drives = member(linkages[i], "drives");
      for (std::size_t d = 0; d < drives.size(); ++d) {
        const Json& driven = member(drives[d], "dyad");
        const bool is_one = driven.is_number_unsigned() && driven.get<std::size_t>() < dyads.size();
        if (is_one && member(dyads[driven.get<std::size_t>()], "type") == "slider") {
          sliding_drives_.insert(fmt::format("{}/{}/{}", t, i, d));
        }
      }
    }
  }
}

const ValueUnit& ReportUnits::beside(const Json& object, std::string_view key) const {
  while (!key.empty()) {
    const auto own = object.find(fmt::format("{}_unit", key));
    if (own != object.end()) {
      return named(*own);
    }
    const std::size_t word = key.rfind('_');
    key = key.substr(0, word == std::string_view::npos ? 0 : word);
  }
  return named(member(object, "unit"));
}

const ValueUnit& ReportUnits::named(const Json& text) const {
  static const std::string nothing = "?";
  const std::string& name = text.is_string() ? text.get_ref<const std::string&>() : nothing;
  const auto at = named_.find(name);
  return at != named_.end() ? at->second
                            : named_.emplace(name, unit_or(name, unknown_)).first->second;
}

const ValueUnit& ReportUnits::unit_of(const Shape* shape, const Labels& labels) const {
  if (shape == nullptr) {
    return unknown_;
  }
  if (const auto* kind = std::get_if<QuantityKind>(&shape->measure)) {
    return of(*kind);
  }
  if (const auto* bare = std::get_if<Bare>(&shape->measure)) {
    return bare_unit_of(*bare);
  }
  const std::string_view label = labels.empty() ? std::string_view() : labels.back();
  switch (std::get<ByContext>(shape->measure)) {
    case ByContext::rate:
      return rate(label);
    case ByContext::action:
      return action(label);
    case ByContext::rate_ratio:
      return ratio(rate_ratios_, labels);
    case ByContext::action_ratio:
      return ratio(action_ratios_, labels);
    case ByContext::coefficient:
      return labels.size() < 2 ? unknown_ : coefficient(labels[labels.size() - 2], label);
    case ByContext::drive:
      return drive(label);
    case ByContext::column:
      return column(label);
    case ByContext::coordinate:
      return coordinate(labels);
    case ByContext::per_length:
      return per_length_;
    case ByContext::beside:
    case ByContext::relative:
      return unknown_;
  }
  return unknown_;
}

const ValueUnit& ReportUnits::rate(std::string_view freedom) const {
  switch (letter_of(freedom)) {
    case 'w':
      return of(QuantityKind::angular_velocity);
    case 'v':
      return of(QuantityKind::velocity);
    default:
      return unknown_;
  }
}

// The reaction of a coupling, "a.Rx", "a.Tz" or "rope_1.F", or an actuator.
const ValueUnit& ReportUnits::action(std::string_view name) const {
  const auto actuator = actuators_.find(name);
  const char kind = actuator == actuators_.end() ? letter_of(name) : actuator->second;
  if (kind == 'T' || kind == 'w') {
    return of(QuantityKind::moment);
  }
  const bool is_force = kind == 'R' || kind == 'F' || kind == 'v';
  return is_force ? of(QuantityKind::force) : unknown_;
}

// Its case names the unit where input and output differ, or the shift table, there by output if it
// has several. Where neither does, the ratio of two alike is bare; which two it is of, the report
// does not say.
const ValueUnit& ReportUnits::ratio(const RatioUnits& units, const Labels& labels) const {
  if (const auto at = units.of_cases.find(labels.empty() ? std::string_view() : labels.back());
      labels.size() < 2 && at != units.of_cases.end()) {
    return at->second;
  }
  if (const auto at = units.of_outputs.find(labels.size() < 2 ? std::string_view() : labels.back());
      at != units.of_outputs.end()) {
    return at->second;
  }
  return ratio_;
}

// By its name, or by its number in the order of the file.
const ValueUnit& ReportUnits::drive(std::string_view label) const {
  auto at = std::ranges::find(drives_, label, [](const auto& one) { return one.first; });
  std::ptrdiff_t i = 0;
  if (at == drives_.end() &&
      std::from_chars(label.data(), label.data() + label.size(), i).ec == std::errc() && i >= 0 &&
      i < std::ssize(drives_)) {
    at = drives_.begin() + i;
  }
  return at == drives_.end() ? unknown_ : at->second;
}

const ValueUnit& ReportUnits::column(std::string_view name) const {
  const auto at = columns_.find(name);
  return at == columns_.end() ? unknown_ : at->second;
}

const ValueUnit& ReportUnits::parameter(std::string_view name) const {
  const auto at = parameters_.find(name);
  return at == parameters_.end() ? unknown_ : at->second;
}

const ValueUnit& ReportUnits::magnitude(std::string_view name) const {
  const bool is_rate = letter_of(name) == 'w' || letter_of(name) == 'v';
  return is_rate ? rate(name) : action(name);
}

const ValueUnit& ReportUnits::per(const Json& reference,
                                  const Shape& shape,
                                  const Labels& labels) const {
  return quotient(references_, unit_of(&shape, labels), named(reference), unit_per);
}

// By the numbers of task, linkage and drive.
const ValueUnit& ReportUnits::coordinate(const Labels& labels) const {
  if (labels.size() < 3) {
    return unknown_;
  }
  const bool slides =
      sliding_drives_.contains(fmt::format("{}/{}/{}", labels[0], labels[1], labels[2]));
  return of(slides ? QuantityKind::length : QuantityKind::angle);
}

// Of a magnitude per parameter; "1" is the constant.
const ValueUnit& ReportUnits::coefficient(std::string_view magnitude, std::string_view name) const {
  const ValueUnit& above = this->magnitude(magnitude);
  return name == "1" ? above : quotient(coefficients_, above, parameter(name), unit_of_coefficient);
}

}  // namespace kinestat
