#include "forms/parts.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "io/cut_value.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

constexpr std::array<std::string_view, 6> kCounts = {"none", "one", "two", "three", "four", "five"};

// "with something in it", "of at least two", "of one to four", "of two".
std::string number_text(const FormShape& shape) {
  if (shape.most == FormShape::kAnyNumber) {
    return shape.least == 1 ? "with something in it"
                            : "of at least " + std::string(kCounts.at(shape.least));
  }
  const std::string most(kCounts.at(shape.most));
  return shape.least == shape.most ? "of " + most
                                   : fmt::format("of {} to {}", kCounts.at(shape.least), most);
}

FileValue part_of(const FileValue& whole, const YamlNode& node, SourceRange where) {
  return {.node = node,
          .what = whole.what,
          .key = whole.key,
          .owner = whole.owner,
          .where = where,
          .place = node.where,
          .space = whole.space,
          .found = whole.found};
}

std::string_view key_of(const FileValue& value) {
  return value.key != nullptr ? value.key->key : "key";
}

// "write trace: [{body: NAME, at: [x, y]}]"
std::string list_hint(const FileValue& value, const FormShape& shape) {
  return fmt::format(
      "write {}: {}", key_of(value), sketch_of(shape, value.space.value_or(Space::spatial)));
}

// Of names the lines that are meant, of values an example.
std::string names_hint(const FileValue& value, const FormShape& shape) {
  const bool has_example = value.key != nullptr && !value.key->examples.empty();
  if (!is_mapping(shape.items.front()) && has_example) {
    return fmt::format("write for example {}: {}", key_of(value), value.key->examples.front());
  }
  return fmt::format("write {}: and below it indented lines '{}: {{…}}'",
                     key_of(value),
                     shape.name_definition.empty() ? "label" : "name");
}

}  // namespace

FileValue item_of(const FileValue& list, std::size_t index, const std::string& title) {
  FileValue item = part_of(list, list.node.items[index], list.node.items[index].where);
  if (!title.empty()) {
    item.what = Title(title, index + 1, list.owner);
  }
  return item;
}

FileValue element_of(const FileValue& names, const YamlEntry& entry, const std::string& title) {
  FileValue element = part_of(names, entry.value, entry.key_where);
  element.what = Title(title, std::string_view(entry.key), &names.what, key_of(names));
  return element;
}

bool check_items(const FileValue& value, const FormShape& shape, const std::string& hint) {
  const YamlNode& node = value.node;
  const bool is_list = node.kind == YamlKind::sequence;
  if (report_cut_value(node, value.found)) {
    return false;
  }
  if (is_list && node.items.size() >= shape.least && node.items.size() <= shape.most) {
    return true;
  }
  const bool is_plain = !is_list && shape.least <= 1 && shape.most == FormShape::kAnyNumber;
  value.found.error(
      "E0304",
      node.where,
      fmt::format("{} must be a list{}", value.what, is_plain ? "" : " " + number_text(shape)),
      hint.empty() ? list_hint(value, shape) : hint);
  return false;
}

bool check_names(const FileValue& value, const FormShape& shape) {
  const YamlNode& node = value.node;
  if (node.kind == YamlKind::mapping && node.entries.size() >= shape.least) {
    return true;
  }
  const std::string_view elements = shape.name_definition.empty() ? "labels" : "names";
  value.found.error("E0304",
                    node.where,
                    fmt::format("{} must be a mapping of {}",
                                value.what,
                                shape.elements.empty() ? elements : shape.elements),
                    names_hint(value, shape));
  return false;
}

std::size_t count_whole(const YamlNode& names, const FormShape& element) {
  const SharedList<FormKey>& keys =
      element.kind == FormKind::by_word ? element.items.front()->keys : element.keys;
  const auto needed = std::ranges::count_if(keys, &FormKey::is_needed);
  return static_cast<std::size_t>(std::ranges::count_if(
      names.entries, [&](const auto& entry) { return std::ssize(entry.value.entries) >= needed; }));
}

void check_element_name(const Name& name, const FormShape& shape, Diagnostics& found) {
  if (shape.name_definition == "new_name") {
    check_name(name, shape.item, found);
  }
}

std::string element_key(const Name& name, const FormShape& shape) {
  return shape.name_definition.empty() ? in_quotes(name.text) : name.text;
}

}  // namespace kinestat
