// The section `cases`.
#include <algorithm>

#include <fmt/format.h>

#include "format/sections/sections.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

Form<std::vector<Assignment>> assignments(const Form<Value>& value) {
  return values_by_name(&Assignment::target,
                        &Assignment::value,
                        value,
                        {.elements = "names to values", .name_definition = "target"},
                        "'{0}'");
}

Form<std::vector<Name>> ends() {
  return one_or_more(power_end(), 1);
}

const Mapping<CaseDescription>& one_case() {
  static const Mapping<CaseDescription> mapping(
      "case",
      "What is known in this case; everything else is solved.",
      "{motion: {load: 1 rad/s}, action: {load: 1 N*m}, input: drive, output: load}",
      [](auto& m) {
        m.write_in_lines();
        m.key("motion",
              "The known motions: actuators or COUPLING.FREEDOM (d.wz), of the head relative to "
              "the tail; as many independent ones as the net degree of freedom. Default units: "
              "rad/s and m/s.")
            .may(&CaseDescription::motions, assignments(speed()), "{drive: 1 rad/s, d.wz: 0}")
            .noted(&CaseDescription::asks_motions);
        m.key("acceleration",
              "Rates of change of the known motions: with this key, even if empty, the inertia "
              "forces of all bodies with mass or inertia act. Motions not named here are constant.")
            .may(
                &CaseDescription::accelerations, assignments(speed_change()), "{drive: 50 rad/s^2}")
            .noted(&CaseDescription::has_inertia);
        m.key("action",
              "The known actions: actuators or COUPLING.ACTION (c.Rx), of the tail on the head. "
              "Default units: N*m and N.")
            .may(&CaseDescription::actions, assignments(action()), "{load: 1 N*m, c.Rx: 0}")
            .noted(&CaseDescription::asks_actions);
        m.key("loads",
              "Loads of this case only; they replace those of the same name at the top level.")
            .may(&CaseDescription::loads, loads());
        m.key("input",
              "Where power enters: one actuator or several, or a driving load (gravity.BODY for a "
              "weight); with the output it defines ratio and efficiency.")
            .may(&CaseDescription::inputs, ends(), "drive");
        m.key("output",
              "Where power leaves: one actuator or several, or a load, such as the one on a hoist; "
              "needs 'input'.")
            .may(&CaseDescription::outputs, ends(), "load");
        m.rule({.kind = FormRule::Kind::any_of,
                .others = {"motion", "action", "loads"},
                .message = "{} names neither motions nor actions",
                .hint = "add 'motion: {…}' for velocities, 'action: {…}' or 'loads: {…}' for "
                        "forces, or both"});
        m.rule({.kind = FormRule::Kind::together,
                .key = "acceleration",
                .others = {"motion"},
                .message = "{} has accelerations but no motions",
                .hint = "add 'motion: {NAME: 0}' for what is at rest and speeds up, or its speed"});
        m.rule({.kind = FormRule::Kind::together,
                .key = "output",
                .others = {"input"},
                .message = "{} names an output but no input",
                .hint = "add 'input: NAME', an actuator, or remove 'output'"});
      });
  return mapping;
}

// A key of a case that is indented like its label, which is then empty.
const YamlEntry* find_misplaced_key(const YamlNode& node) {
  const bool has_empty_label = std::ranges::any_of(
      node.entries, [](const YamlEntry& entry) { return entry.value.kind == YamlKind::null; });
  const auto at = std::ranges::find_if(node.entries, [](const YamlEntry& entry) {
    return entry.key == "motion" || entry.key == "action" || entry.key == "loads";
  });
  return has_empty_label && at != node.entries.end() ? &*at : nullptr;
}

}  // namespace

Form<std::vector<CaseDescription>> cases() {
  auto form = named(&CaseDescription::label, one_case().form(), {.item = "a case"}, "case '{0}'");
  form.read =
      [read = form.read](const FileValue& value) -> std::optional<std::vector<CaseDescription>> {
    if (const YamlEntry* key = find_misplaced_key(value.node)) {
      value.found.error("E0304",
                        key->key_where,
                        fmt::format("'{}' is at the level of the case labels", key->key),
                        "a case is 'label:' with its keys below it, indented further");
      return std::nullopt;
    }
    return read(value);
  };
  return form;
}

}  // namespace kinestat
