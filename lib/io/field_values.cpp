#include "io/field_values.hpp"

#include <algorithm>

namespace kinestat {

SourceRange place_of_key(const YamlNode& mapping, std::string_view key) {
  const auto at = std::ranges::find(mapping.entries, key, &YamlEntry::key);
  return at != mapping.entries.end() ? at->key_where : mapping.where;
}

}  // namespace kinestat
