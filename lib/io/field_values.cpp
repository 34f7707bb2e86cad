#include "io/field_values.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "io/value_reader.hpp"

namespace kinestat {

namespace {

std::string title(std::string_view key, const Fields& fields) {
  return fmt::format("'{}' of {}", key, fields.what());
}

}  // namespace

std::optional<Value> find_value(Fields& fields, std::string_view key, Diagnostics& found) {
  const YamlNode* node = fields.find(key);
  return node == nullptr ? std::nullopt : read_value(*node, title(key, fields), found);
}

bool find_bool(Fields& fields, std::string_view key, Diagnostics& found) {
  const YamlNode* node = fields.find(key);
  return node != nullptr && read_bool(*node, title(key, fields), found).value_or(false);
}

std::optional<PointDescription> find_point(Fields& fields,
                                           std::string_view key,
                                           Space space,
                                           Diagnostics& found) {
  const YamlNode* node = fields.find(key);
  return node == nullptr ? std::nullopt : read_point(*node, title(key, fields), space, found);
}

std::optional<std::size_t> find_word(Fields& fields,
                                     std::string_view key,
                                     std::span<const std::string> words,
                                     Diagnostics& found) {
  const YamlNode* node = fields.find(key);
  return node == nullptr ? std::nullopt : read_word(*node, title(key, fields), words, found);
}

Value require_value(Fields& fields, std::string_view key, Diagnostics& found) {
  const YamlNode* node = fields.require(key);
  const auto value = node == nullptr ? std::nullopt : read_value(*node, title(key, fields), found);
  return value.value_or(Value{});
}

PointDescription require_point(Fields& fields,
                               std::string_view key,
                               Space space,
                               Diagnostics& found) {
  const YamlNode* node = fields.require(
      key, fmt::format("'{}: {}'", key, space == Space::planar ? "[x, y]" : "[x, y, z]"));
  const auto point =
      node == nullptr ? std::nullopt : read_point(*node, title(key, fields), space, found);
  return point.value_or(PointDescription{});
}

SourceRange place_of_key(const YamlNode& mapping, std::string_view key) {
  const auto at = std::ranges::find(mapping.entries, key, &YamlEntry::key);
  return at != mapping.entries.end() ? at->key_where : mapping.where;
}

}  // namespace kinestat
