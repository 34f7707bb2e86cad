#include "format/form.hpp"

#include <fmt/format.h>

#include "io/cut_value.hpp"

namespace kinestat {

namespace {

// "with something in it", "of at least 2", "of 1 to 4", "of 2".
std::string number_text(const FormShape& shape) {
  if (shape.most == FormShape::kAnyNumber) {
    return shape.least == 1 ? "with something in it" : fmt::format("of at least {}", shape.least);
  }
  return shape.least == shape.most ? fmt::format("of {}", shape.most)
                                   : fmt::format("of {} to {}", shape.least, shape.most);
}

}  // namespace

FileValue item_of(const FileValue& list, std::size_t index, const std::string& title) {
  const YamlNode& node = list.node.items[index];
  return {
      .node = node,
      .what = title.empty() ? list.what : fmt::format(fmt::runtime(title), index + 1, list.owner),
      .key = list.key,
      .owner = list.owner,
      .where = node.where,
      .place = node.where,
      .space = list.space,
      .found = list.found};
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
      hint.empty()
          ? fmt::format(
                "write {}: {}", value.key, sketch_of(shape, value.space.value_or(Space::spatial)))
          : hint);
  return false;
}

std::string in_brackets(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ", "));
}

std::string in_braces(const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string text;
  for (const auto& [key, value] : entries) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", key, value);
  }
  return "{" + text + "}";
}

}  // namespace kinestat
