#include "io/value_reader.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "expression/evaluate.hpp"
#include "io/cut_value.hpp"
#include "io/synonyms.hpp"

namespace kinestat {

namespace {

constexpr const char* kQuote = "put it in quotes: '{}'";

// A space of another kind behind a ':' makes key and value one key.
std::string missing_value_hint(const Title& what) {
  const std::string foreign = foreign_character(what.text());
  return foreign.empty()
             ? "write the value behind the ':'"
             : fmt::format("write the value behind ': '; the name before it holds {}", foreign);
}

bool check_scalar(const YamlNode& node, const Title& what, Diagnostics& found) {
  if (node.kind == YamlKind::scalar) {
    return true;
  }
  const std::string_view shape = node.kind == YamlKind::null       ? "is empty"
                                 : node.kind == YamlKind::sequence ? "is a list"
                                                                   : "is a mapping";
  found.error(
      "E0304",
      node.where,
      fmt::format("{} {} where a single value is expected", what, shape),
      node.kind == YamlKind::null ? missing_value_hint(what) : "write one value, without brackets");
  return false;
}

// Other readers of YAML would not take it for a text either.
bool check_no_truth_value(const YamlNode& node,
                          const Title& what,
                          std::string_view asked,
                          std::string_view hint,
                          Diagnostics& found) {
  if (!is_truth_value(node)) {
    return true;
  }
  found.error("E0304",
              node.where,
              fmt::format("{} is the truth value {} where {} is expected", what, node.text, asked),
              fmt::format(fmt::runtime(hint), node.text));
  return false;
}

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_whole_number(const YamlNode& node) {
  const std::string_view digits =
      std::string_view(node.text).substr(node.text.starts_with('-') ? 1 : 0);
  return node.kind == YamlKind::scalar && !digits.empty() && std::ranges::all_of(digits, is_digit);
}

// "[1.5, 0.0]" of the items 1, 5, 0, 0.
std::string with_decimal_points(const YamlNode& node) {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i + 1 < node.items.size(); i += 2) {
    numbers.push_back(node.items[i].text + "." + node.items[i + 1].text);
  }
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

// "2.5" of [2,5, 3]: two whole numbers with nothing but a comma between them, where others have a
// space; empty if there are none.
std::string tight_decimal(const YamlNode& node) {
  std::string tight;
  bool has_wide = false;
  for (std::size_t i = 0; i + 1 < node.items.size(); ++i) {
    const YamlNode& left = node.items[i];
    const YamlNode& right = node.items[i + 1];
    const bool is_tight = left.where.line == right.where.line &&
                          left.where.column + left.where.length + 1 == right.where.column;
    has_wide = has_wide || !is_tight;
    if (is_tight && tight.empty() && is_whole_number(left) && is_whole_number(right)) {
      tight = left.text + "." + right.text;
    }
  }
  return has_wide ? tight : "";
}

bool is_number_like(std::string_view text) {
  return text.find_first_of("0123456789") <= text.find_first_not_of("+-.");
}

// What to type where a point has the wrong number of components.
std::string components_hint(const YamlNode& node, const Title& what, std::size_t count) {
  const std::string form = count == 2 ? "write [x, y]" : "write [x, y, z]";
  const std::string decimal = tight_decimal(node);
  if (node.items.size() == 2 * count && std::ranges::all_of(node.items, is_whole_number)) {
    return fmt::format("{}; a decimal has a point: {}", form, with_decimal_points(node));
  }
  if (node.items.size() > count && !decimal.empty()) {
    return fmt::format("{}; a decimal has a point: {}", form, decimal);
  }
  if (node.kind == YamlKind::scalar && is_number_like(node.text)) {
    // Of gravity people give the size, and the number alone would be in the file's unit.
    const std::string last = what.text() == "'gravity'" ? "-9.81 m/s^2" : node.text;
    return fmt::format("{}, for example [{}, {}]", form, count == 2 ? "0" : "0, 0", last);
  }
  if (count == 2 && node.items.size() == 3) {
    return form + "; points in the plane have no z";
  }
  if (count == 3 && node.items.size() == 2) {
    return form + "; where all points of the file have two components, add 'space: planar'";
  }
  const std::string listed = node.items.size() == 1 ? with_commas(node.items.front()) : "";
  return listed.empty() ? form : fmt::format("write [{}]: a comma between the components", listed);
}

std::optional<std::vector<Value>> read_components(const YamlNode& node,
                                                  const Title& what,
                                                  Space space,
                                                  Diagnostics& found) {
  const std::size_t count = space == Space::planar ? 2 : 3;
  if (report_cut_value(node, found) || report_loose_end(node, found)) {
    return std::nullopt;
  }
  if (node.kind != YamlKind::sequence || node.items.size() != count) {
    const std::size_t given = node.kind == YamlKind::sequence ? node.items.size() : 1;
    found.error("E0304",
                node.where,
                node.kind == YamlKind::null      ? fmt::format("{} is empty", what)
                : node.kind == YamlKind::mapping ? fmt::format("{} is a mapping", what)
                                                 : fmt::format("{} has {}, {} space needs {}",
                                                               what,
                                                               counted(given, "component"),
                                                               count == 2 ? "planar" : "spatial",
                                                               count),
                components_hint(node, what, count));
    return std::nullopt;
  }
  std::vector<Value> values;
  for (const YamlNode& item : node.items) {
    if (item.kind == YamlKind::null) {
      found.error("E0304",
                  item.where,
                  fmt::format("{} is empty where a single value is expected", what),
                  "write a number or an expression in its place");
    } else if (std::optional<Value> value = read_value(item, what, found)) {
      values.push_back(*std::move(value));
    }
  }
  return values.size() == count ? std::optional(std::move(values)) : std::nullopt;
}

}  // namespace

std::string with_commas(const YamlNode& node) {
  constexpr std::string_view kBetween = " ;,";
  if (node.kind != YamlKind::scalar || node.text.find_first_of(kBetween) == std::string::npos) {
    return {};
  }
  std::string listed;
  for (const char c : node.text) {
    const bool is_between = kBetween.find(c) != std::string_view::npos;
    listed += !is_between ? std::string(1, c) : listed.ends_with(", ") ? "" : ", ";
  }
  return listed;
}

std::optional<std::string> read_text(const YamlNode& node, const Title& what, Diagnostics& found) {
  return check_scalar(node, what, found) &&
                 check_no_truth_value(node, what, "a text", kQuote, found)
             ? std::optional(node.text)
             : std::nullopt;
}

std::optional<Name> read_reference(const YamlNode& node, const Title& what, Diagnostics& found) {
  if (!check_scalar(node, what, found) ||
      !check_no_truth_value(node, what, "a name", kQuote, found)) {
    return std::nullopt;
  }
  return Name{.text = node.text, .where = node.where};
}

bool check_name(const Name& name, const Title& what, Diagnostics& found) {
  const std::string& text = name.text;
  const bool is_good =
      !text.empty() && is_letter(text.front()) &&
      std::ranges::all_of(text, [](char c) { return is_letter(c) || is_digit(c) || c == '-'; });
  if (!is_good) {
    const std::string foreign = foreign_character(text);
    found.error("E0306",
                name.where,
                fmt::format("'{}' cannot be the name of {}{}{}",
                            text,
                            what,
                            foreign.empty() ? "" : ": it holds ",
                            foreign),
                "use letters, digits, '_' and '-', beginning with a letter or '_'");
  }
  return is_good;
}

std::optional<Value> read_value(const YamlNode& node, const Title& what, Diagnostics& found) {
  if (!check_scalar(node, what, found) ||
      !check_no_truth_value(node, what, "a number", "write a number or an expression", found) ||
      report_loose_end(node, found)) {
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

std::optional<double> read_number(const YamlNode& node, const Title& what, Diagnostics& found) {
  const std::optional<Value> value = read_value(node, what, found);
  if (!value) {
    return std::nullopt;
  }
  static const FileUnits units;  // a plain number has none
  const auto number = evaluate_as(QuantityKind::dimensionless, value->expression, units, no_names);
  if (const auto* error = std::get_if<ExpressionError>(&number)) {
    found.error(
        error->code,
        place_in(*value, *error),
        fmt::format("{} must be a plain number: {}", what, error->message),
        error->code == std::string_view("E0309")
            ? "write the number of the report, in the unit that it has there, without the unit"
            : error->hint);
    return std::nullopt;
  }
  return std::get<double>(number);
}

std::optional<bool> read_bool(const YamlNode& node, const Title& what, Diagnostics& found) {
  if (is_truth_value(node)) {
    return node.text == "true";
  }
  if (report_loose_end(node, found)) {
    return std::nullopt;
  }
  const bool is_word = node.text == "true" || node.text == "false";
  found.error("E0304",
              node.where,
              node.kind == YamlKind::scalar ? fmt::format("{} cannot be '{}'", what, node.text)
                                            : fmt::format("{} is true or false", what),
              is_word ? "write true or false without quotes" : "write true or false");
  return std::nullopt;
}

void complain_of_word(const YamlNode& node,
                      const Title& what,
                      std::span<const std::string> words,
                      Diagnostics& found) {
  const bool is_collection = node.kind == YamlKind::sequence || node.kind == YamlKind::mapping;
  if (is_collection && words.size() <= 3) {
    found.error("E0304",
                node.where,
                fmt::format("{} is a {} where a single value is expected",
                            what,
                            node.kind == YamlKind::sequence ? "list" : "mapping"),
                fmt::format("write {}, without brackets", fmt::join(words, " or ")));
    return;
  }
  if (!check_scalar(node, what, found) || report_loose_end(node, found)) {
    return;
  }
  const std::string guess = did_you_mean_word(node.text, words);
  found.error(
      "E0305",
      node.where,
      fmt::format("{} cannot be '{}'", what, node.text),
      fmt::format("{}{}it is one of {}", guess, guess.empty() ? "" : " ", plain_list(words, 40)));
}

std::optional<PointDescription> read_point(const YamlNode& node,
                                           const Title& what,
                                           Space space,
                                           Diagnostics& found) {
  std::optional<std::vector<Value>> components = read_components(node, what, space, found);
  if (!components) {
    return std::nullopt;
  }
  return PointDescription{.coordinates = *std::move(components), .where = node.where};
}

std::optional<AxisDescription> read_axis(const YamlNode& node,
                                         const Title& what,
                                         Space space,
                                         Diagnostics& found) {
  if (node.kind == YamlKind::scalar) {
    static const std::vector<std::string> kAxisWords = {"x", "y", "z", "-x", "-y", "-z"};
    const auto word = std::ranges::find(kAxisWords, node.text);
    if (word == kAxisWords.end() && report_loose_end(node, found)) {
      return std::nullopt;
    }
    if (word == kAxisWords.end()) {
      found.error(
          "E0305",
          node.where,
          fmt::format("{} cannot be '{}'", what, node.text),
          fmt::format("write x, y, z, -x, … or a vector such as {}",
                      space == Space::planar ? "[cos(30 deg), sin(30 deg)]" : "[1, 0, 0.5]"));
      return std::nullopt;
    }
    return AxisDescription{.keyword = word->back(),
                           .sign = word->size() == 1 ? 1.0 : -1.0,
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
