#include "io/unit_reader.hpp"

#include <fmt/format.h>

#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

void read_units(const YamlNode& node, FileUnits& units, Diagnostics& found) {
  Fields fields(node, node.where, "'units'", found);
  for (const QuantityKind kind : all_quantity_kinds()) {
    const std::string_view key = key_of(kind);
    const YamlNode* entry = key.empty() ? nullptr : fields.find(key);
    if (entry == nullptr) {
      continue;
    }
    const auto text = read_text(*entry, fmt::format("the unit of '{}'", key), found);
    if (!text) {
      continue;
    }
    if (const auto error = units.set(kind, *text)) {
      found.error(error->code,
                  place_in(entry->where, entry->text_column, *text, error->offset, error->length),
                  error->message,
                  error->hint);
    }
  }
  fields.finish();
}

}  // namespace kinestat
