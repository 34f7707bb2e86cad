#include "io/mechanism_writer.hpp"

#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"

namespace kinestat {

namespace {

// A text between double quotes, so that nothing in it has a meaning of its own.
std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : printable(text)) {
    result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  }
  return result + "\"";
}

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

std::string body_text(const BodyDescription& body) {
  KINESTAT_EXPECTS(!body.mass && !body.centre_of_mass && body.outline.empty());
  return body.reference ? fmt::format("  {}: {{reference: {}}}\n",
                                      body.name.text,
                                      list_text(body.reference->coordinates))
                        : fmt::format("  {}:\n", body.name.text);
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

std::string actuator_text(const ActuatorDescription& actuator) {
  return fmt::format("  {}: {{coupling: {}{}}}\n",
                     actuator.name.text,
                     actuator.coupling.text,
                     actuator.freedom ? ", freedom: " + actuator.freedom->text : "");
}

std::string names_text(std::string_view key, const std::vector<Name>& names) {
  std::vector<std::string> words;
  words.reserve(names.size());
  for (const Name& name : names) {
    words.push_back(name.text);
  }
  return names.empty() ? "" : fmt::format("    {}: [{}]\n", key, plain_list(words, words.size()));
}

std::string case_text(const CaseDescription& one) {
  KINESTAT_EXPECTS(!one.asks_actions && one.loads.empty());
  std::string motions;
  for (const Assignment& motion : one.motions) {
    motions += fmt::format("{}{}: {}",
                           motions.empty() ? "" : ", ",
                           motion.target.text,
                           motion.value.expression.text());
  }
  return fmt::format("  {}:\n    motion: {{{}}}\n", in_quotes(one.label.text), motions) +
         names_text("input", one.inputs) + names_text("output", one.outputs);
}

std::string range_text(const DriveRange& range) {
  KINESTAT_EXPECTS(range.to.has_value());
  return fmt::format("drive: {}{}, to: {}",
                     range.actuator.text,
                     range.from ? ", from: " + range.from->expression.text() : "",
                     range.to->expression.text());
}

std::string trace_text(const std::vector<TracePoint>& trace) {
  std::string text;
  for (const TracePoint& point : trace) {
    text += fmt::format("{}{{body: {}, at: {}}}",
                        text.empty() ? "" : ", ",
                        point.body.text,
                        list_text(point.at.coordinates));
  }
  return text.empty() ? "" : ", trace: [" + text + "]";
}

std::string motion_text(const MotionDescription& motion) {
  KINESTAT_EXPECTS(motion.drives.size() == 1 && motion.report.empty());
  return fmt::format("\nmotion: {{{}{}{}{}}}\n",
                     range_text(motion.drives.front()),
                     motion.steps ? ", steps: " + motion.steps->expression.text() : "",
                     motion.label ? ", case: " + in_quotes(motion.label->text) : "",
                     trace_text(motion.trace));
}

template <class Items, class Write>
std::string section_text(std::string_view key, const Items& items, Write write) {
  std::string text;
  for (const auto& item : items) {
    text += write(item);
  }
  return text.empty() ? "" : fmt::format("\n{}:\n{}", key, text);
}

bool has_more(const MechanismDescription& d) {
  return !d.parameters.empty() || d.tree || d.kinematic_order != OrderChoice::minimal ||
         d.static_order != OrderChoice::minimal || d.gears || !d.cables.empty() ||
         !d.loads.empty() || d.gravity || d.losses ||
         d.indeterminate != IndeterminateChoice::report || d.shift || d.sweep || d.synthesis ||
         !d.published.empty();
}

}  // namespace

std::string mechanism_text(const MechanismDescription& description,
                           std::span<const std::string> head) {
  KINESTAT_EXPECTS(!has_more(description));
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
  text += section_text("bodies", description.bodies, body_text);
  text += section_text("couplings", description.couplings, coupling_text);
  text += section_text("actuators", description.actuators, actuator_text);
  text += section_text("cases", description.cases, case_text);
  text += description.motion ? motion_text(*description.motion) : "";
  return text;
}

}  // namespace kinestat
