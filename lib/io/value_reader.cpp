#include "io/value_reader.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/text.hpp"
#include "expression/evaluate.hpp"

namespace kinestat {

namespace {

bool check_scalar(const YamlNode& node, std::string_view what, Diagnostics& found) {
  if (node.kind == YamlKind::scalar) {
    return true;
  }
  const std::string_view shape = node.kind == YamlKind::null       ? "is empty"
                                 : node.kind == YamlKind::sequence ? "is a list"
                                                                   : "is a mapping";
  found.error(
      "E0304", node.where, fmt::format("{} {} where a single value is expected", what, shape));
  return false;
}

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::optional<std::vector<Value>> read_components(const YamlNode& node,
                                                  std::string_view what,
                                                  Space space,
                                                  Diagnostics& found) {
  const std::size_t count = space == Space::planar ? 2 : 3;
  if (node.kind != YamlKind::sequence || node.items.size() != count) {
    found.error("E0304",
                node.where,
                fmt::format("{} needs {} components in {} space",
                            what,
                            count,
                            space == Space::planar ? "planar" : "spatial"),
                space == Space::planar ? "write [x, y]" : "write [x, y, z]");
    return std::nullopt;
  }
  std::vector<Value> values;
  for (const YamlNode& item : node.items) {
    if (std::optional<Value> value = read_value(item, what, found)) {
      values.push_back(*std::move(value));
    }
  }
  return values.size() == count ? std::optional(std::move(values)) : std::nullopt;
}

}  // namespace

std::optional<std::string> read_text(const YamlNode& node,
                                     std::string_view what,
                                     Diagnostics& found) {
  return check_scalar(node, what, found) ? std::optional(node.text) : std::nullopt;
}

std::optional<Name> read_reference(const YamlNode& node,
                                   std::string_view what,
                                   Diagnostics& found) {
  if (!check_scalar(node, what, found)) {
    return std::nullopt;
  }
  return Name{.text = node.text, .where = node.where};
}

std::optional<std::vector<Name>> read_references(const YamlNode& node,
                                                 std::string_view what,
                                                 Diagnostics& found) {
  std::vector<Name> names;
  const std::span<const YamlNode> items =
      node.kind == YamlKind::sequence ? std::span(node.items) : std::span(&node, 1);
  for (const YamlNode& item : items) {
    std::optional<Name> name = read_reference(item, what, found);
    if (!name) {
      return std::nullopt;
    }
    names.push_back(*std::move(name));
  }
  return names;
}

bool check_name(const Name& name, std::string_view what, Diagnostics& found) {
  const std::string& text = name.text;
  const bool is_good =
      !text.empty() && is_letter(text.front()) &&
      std::ranges::all_of(text, [](char c) { return is_letter(c) || is_digit(c) || c == '-'; });
  if (!is_good) {
    found.error("E0306",
                name.where,
                fmt::format("'{}' cannot be the name of {}", text, what),
                "use letters, digits, '_' and '-', beginning with a letter or '_'");
  }
  return is_good;
}

std::optional<Value> read_value(const YamlNode& node, std::string_view what, Diagnostics& found) {
  if (!check_scalar(node, what, found)) {
    return std::nullopt;
  }
  auto parsed = parse_expression(node.text);
  if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
    found.error(error->code,
                place_in(node.where, node.text_column, node.text, error->offset, error->length),
                error->message,
                error->hint);
    return std::nullopt;
  }
  return Value{.expression = std::get<Expression>(std::move(parsed)),
               .where = node.where,
               .text_column = node.text_column};
}

std::optional<double> read_number(const YamlNode& node, std::string_view what, Diagnostics& found) {
  const std::optional<Value> value = read_value(node, what, found);
  if (!value) {
    return std::nullopt;
  }
  const auto number =
      evaluate_as(QuantityKind::dimensionless, value->expression, FileUnits(), no_names);
  if (const auto* error = std::get_if<ExpressionError>(&number)) {
    found.error(error->code,
                place_in(*value, *error),
                fmt::format("{} must be a plain number: {}", what, error->message),
                error->hint);
    return std::nullopt;
  }
  return std::get<double>(number);
}

std::optional<bool> read_bool(const YamlNode& node, std::string_view what, Diagnostics& found) {
  if (node.kind == YamlKind::scalar && !node.quoted &&
      (node.text == "true" || node.text == "false")) {
    return node.text == "true";
  }
  found.error("E0304", node.where, fmt::format("{} is true or false", what), "write true or false");
  return std::nullopt;
}

std::optional<std::size_t> read_word(const YamlNode& node,
                                     std::string_view what,
                                     std::span<const std::string> words,
                                     Diagnostics& found) {
  if (!check_scalar(node, what, found)) {
    return std::nullopt;
  }
  const auto at = std::ranges::find(words, node.text);
  if (at != words.end()) {
    return static_cast<std::size_t>(at - words.begin());
  }
  const std::string guess = did_you_mean(node.text, words);
  found.error(
      "E0305",
      node.where,
      fmt::format("{} cannot be '{}'", what, node.text),
      fmt::format("{}{}it is one of {}", guess, guess.empty() ? "" : " ", plain_list(words, 40)));
  return std::nullopt;
}

std::optional<PointDescription> read_point(const YamlNode& node,
                                           std::string_view what,
                                           Space space,
                                           Diagnostics& found) {
  std::optional<std::vector<Value>> components = read_components(node, what, space, found);
  if (!components) {
    return std::nullopt;
  }
  return PointDescription{.coordinates = *std::move(components), .where = node.where};
}

std::optional<AxisDescription> read_axis(const YamlNode& node,
                                         std::string_view what,
                                         Space space,
                                         Diagnostics& found) {
  if (node.kind == YamlKind::scalar) {
    static const std::vector<std::string> kWords = {"x", "y", "z", "-x", "-y", "-z"};
    const std::optional<std::size_t> word = read_word(node, what, kWords, found);
    if (!word) {
      return std::nullopt;
    }
    return AxisDescription{.keyword = kWords[*word].back(),
                           .sign = *word < 3 ? 1.0 : -1.0,
                           .components = {},
                           .where = node.where};
  }
  std::optional<std::vector<Value>> components = read_components(node, what, space, found);
  if (!components) {
    return std::nullopt;
  }
  return AxisDescription{
      .keyword = 0, .sign = 1.0, .components = *std::move(components), .where = node.where};
}

}  // namespace kinestat
