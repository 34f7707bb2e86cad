#include "format/mechanism_writer.hpp"

#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "format/sections/sections.hpp"
#include "format/value_forms.hpp"

namespace kinestat {

namespace {

std::string list_text(const std::vector<Value>& values) {
  std::string text;
  for (const Value& value : values) {
    text += (text.empty() ? "" : ", ") + value.expression.text();
  }
  return "[" + text + "]";
}

std::string axis_text(const AxisDescription& axis) {
  return axis.keyword == 0 ? list_text(axis.components)
                           : std::string(axis.sign < 0.0 ? "-" : "") + axis.keyword;
}

void set_unit(FileUnits& units, QuantityKind kind, const std::string& text) {
  const auto error = units.set(kind, text);
  KINESTAT_EXPECTS(!error);
}

// Only what the units before it do not imply, as the velocity follows from the length.
std::string units_text(const FileUnits& units) {
  FileUnits implied;
  std::string text;
  for (const QuantityKind kind : all_quantity_kinds()) {
    if (!key_of(kind).empty() && implied.text(kind) != units.text(kind)) {
      set_unit(implied, kind, units.text(kind));
      text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", key_of(kind), units.text(kind));
    }
  }
  return text.empty() ? "" : "units: {" + text + "}\n";
}

std::string coupling_text(const CouplingDescription& coupling) {
  KINESTAT_EXPECTS(coupling.type == CouplingType::revolute ||
                   coupling.type == CouplingType::prismatic);
  KINESTAT_EXPECTS(!coupling.at || coupling.at->point);
  std::string text = fmt::format("  {}: {{type: {}, bodies: [{}, {}]",
                                 coupling.name.text,
                                 word_of(coupling.type),
                                 coupling.tail.text,
                                 coupling.head.text);
  if (coupling.at) {
    text += ", at: " + list_text(coupling.at->point->coordinates);
  }
  if (coupling.axis) {
    text += ", axis: " + axis_text(*coupling.axis);
  }
  return text + "}\n";
}

std::string couplings_text(const std::vector<CouplingDescription>& couplings) {
  std::string text;
  for (const CouplingDescription& one : couplings) {
    text += coupling_text(one);
  }
  return text.empty() ? "" : "\ncouplings:\n" + text;
}

}  // namespace

std::string mechanism_text(const MechanismDescription& description,
                           std::span<const std::string> head) {
  KINESTAT_EXPECTS(!description.synthesis);
  std::string text;
  for (const std::string& line : head) {
    text += line.empty() ? "#\n" : fmt::format("# {}\n", printable(line));
  }
  text += "kinestat: 1\n";
  text += description.name.empty() ? "" : fmt::format("name: {}\n", in_quotes(description.name));
  text +=
      description.source.empty() ? "" : fmt::format("source: {}\n", in_quotes(description.source));
  text += description.space == Space::planar ? "space: planar\n" : "";
  text += units_text(description.units);
  text += fmt::format("\nground: {}\n", description.ground.text);
  for (const auto& [key, value] : file_sections().text(description).entries) {
    text += fmt::format("\n{}:{}", key, behind_key(value, 0));
    text += key == "bodies" ? couplings_text(description.couplings) : "";
  }
  return text;
}

}  // namespace kinestat
