// The section `units`.
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "expression/file_units.hpp"
#include "format/sections/sections.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

struct UnitKey {
  QuantityKind kind;
  std::string_view meaning;
  SharedList<std::string_view> examples;
};

void read_unit(QuantityKind kind, const FileValue& value, FileUnits& units) {
  const YamlNode& node = value.node;
  const auto text = read_text(node, fmt::format("the unit of '{}'", key_of(kind)), value.found);
  const auto error = text ? units.set(kind, *text) : std::nullopt;
  if (error) {
    value.found.error(error->code,
                      place_in(node.where, node.text_column, *text, error->offset, error->length),
                      error->message,
                      error->hint);
  }
}

// Only what the units before it do not imply, as the velocity follows from the length.
std::optional<FileText> unit_text(QuantityKind kind, const FileUnits& units) {
  FileUnits implied;
  for (const QuantityKind before : all_quantity_kinds()) {
    if (before == kind) {
      break;
    }
    if (!key_of(before).empty()) {
      (void)implied.set(before, units.text(before));
    }
  }
  const bool is_implied = implied.text(kind) == units.text(kind);
  return is_implied ? std::nullopt : std::optional(single_text(units.text(kind)));
}

void declare_unit(const UnitKey& row, Mapping<FileUnits>& m) {
  static const FileUnits usual;
  auto key = m.key(key_of(row.kind), row.meaning);
  key.by(
      FormShape{.kind = FormKind::literal, .sketch = "UNIT"},
      [kind = row.kind](const FileValue& value, FileUnits& units) {
        read_unit(kind, value, units);
      },
      [kind = row.kind](const FileUnits& units) { return unit_text(kind, units); });
  for (const std::string_view example : row.examples) {
    key.example(example);
  }
  if (row.kind != QuantityKind::velocity) {  // which follows from two others
    key.usual(usual.text(row.kind));
  }
}

}  // namespace

const Mapping<FileUnits>& units_section() {
  static const Mapping<FileUnits> mapping("", "", "{length: mm, angle: deg}", [](auto& m) {
    using enum QuantityKind;
    const SharedList<UnitKey> rows = {
        {length, "Unit of bare lengths.", {"mm", "m", "in"}},
        {angle, "Unit of bare angles.", {"deg", "rad"}},
        {time, "Unit of bare times.", {"s", "min"}},
        {mass, "Unit of bare masses.", {"kg", "g"}},
        {inertia, "Unit of bare moments of inertia.", {"kg*m^2", "kg*mm^2"}},
        {force, "Unit of bare forces.", {"N", "kN"}},
        {moment, "Unit of bare moments.", {"N*m", "N*mm", "kN*m"}},
        {velocity, "Unit of bare velocities; default length per time.", {"m/s", "mm/s"}},
        {angular_velocity, "Unit of bare angular velocities.", {"rad/s", "rpm"}},
        {power, "Unit of bare powers.", {"W", "kW"}},
        {energy, "Unit of energies in reports.", {"J", "kJ", "kWh"}},
        {stiffness,
         "Unit of bare stiffnesses of forces. Stiffnesses of couples are in the unit of moment per "
         "rad.",
         {"N/m", "N/mm"}}};
    for (const UnitKey& row : rows) {
      declare_unit(row, m);
    }
  });
  return mapping;
}

}  // namespace kinestat
