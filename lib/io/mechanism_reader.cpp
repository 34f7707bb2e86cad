#include "io/mechanism_reader.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/version.hpp"
#include "io/body_reader.hpp"
#include "io/case_reader.hpp"
#include "io/coupling_reader.hpp"
#include "io/fields.hpp"
#include "io/parameter_reader.hpp"
#include "io/published_reader.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

// Sections of the format that have no analysis in this version.
constexpr auto kLater = std::to_array<std::string_view>({"gears",
                                                         "cables",
                                                         "loads",
                                                         "gravity",
                                                         "losses",
                                                         "statics",
                                                         "shift",
                                                         "motion",
                                                         "sweep",
                                                         "synthesis"});

void read_version(Fields& fields, Diagnostics& found) {
  const YamlNode* node = fields.find("kinestat");
  const std::string hint = fmt::format("the file must say 'kinestat: {}'", kFormatVersion);
  if (node == nullptr) {
    found.error("E0301", fields.where(), "the format version is missing", hint);
    return;
  }
  if (node->kind == YamlKind::scalar && node->text == std::to_string(kFormatVersion)) {
    return;
  }
  const bool is_number = node->kind == YamlKind::scalar && !node->text.empty() &&
                         node->text.find_first_not_of("0123456789") == std::string::npos;
  if (is_number && node->text != "0") {
    found.error("E0301",
                node->where,
                fmt::format("format version {} was made for a newer kinestat; this one reads "
                            "version {}",
                            node->text,
                            kFormatVersion),
                "update kinestat, or rewrite the file in the older format");
    return;
  }
  found.error("E0301", node->where, "the format version is not a positive whole number", hint);
}

void read_head(Fields& fields, MechanismDescription& result, Diagnostics& found) {
  if (const YamlNode* node = fields.find("name")) {
    result.name = read_text(*node, "the name", found).value_or("");
  }
  if (const YamlNode* node = fields.find("source")) {
    result.source = read_text(*node, "the source", found).value_or("");
  }
  if (const YamlNode* node = fields.find("space")) {
    static const std::vector<std::string> kSpaces = {"planar", "spatial"};
    const auto word = read_word(*node, "the space", kSpaces, found);
    result.space = word && *word == 0 ? Space::planar : Space::spatial;
  }
}

std::optional<OrderChoice> read_order_word(const YamlNode& node,
                                           std::string_view what,
                                           Diagnostics& found) {
  static const std::vector<std::string> kOrders = {"minimal", "planar", "spatial"};
  const auto word = read_word(node, what, kOrders, found);
  return word ? std::optional(static_cast<OrderChoice>(*word)) : std::nullopt;
}

void read_order(const YamlNode& node, MechanismDescription& result, Diagnostics& found) {
  result.order_where = node.where;
  Fields fields(node, node.where, "'order'", found);
  if (const YamlNode* order = fields.find("kinematics")) {
    result.kinematic_order = read_order_word(*order, "the order of the kinematics", found)
                                 .value_or(OrderChoice::minimal);
  }
  if (const YamlNode* order = fields.find("statics")) {
    result.static_order =
        read_order_word(*order, "the order of the statics", found).value_or(OrderChoice::minimal);
  }
  fields.finish();
}

// Sections without an analysis are refused; the user's own notes are left alone.
void pass_over(const YamlNode& root, Fields& fields, Diagnostics& found) {
  for (const YamlEntry& entry : root.entries) {
    const bool is_later = std::ranges::find(kLater, entry.key) != kLater.end();
    if (is_later) {
      found.error(
          "E0315",
          entry.key_where,
          fmt::format("section '{}' is not analysed yet by this version", entry.key),
          fmt::format("remove '{}', or keep it as 'x-{}' until then", entry.key, entry.key));
    }
    if (is_later || entry.key.starts_with("x-")) {
      fields.ignore(entry.key);
    }
  }
}

void read_sections(Fields& fields, MechanismDescription& result, Diagnostics& found) {
  if (const YamlNode* node = fields.find("units")) {
    read_units(*node, result.units, found);
  }
  if (const YamlNode* node = fields.find("parameters")) {
    result.parameters = read_parameters(*node, found);
  }
  if (const YamlNode* node = fields.find("tree")) {
    result.tree_where = node->where;
    result.tree = read_references(*node, "the tree", found);
  }
  if (const YamlNode* node = fields.find("order")) {
    read_order(*node, result, found);
  }
  if (const YamlNode* node = fields.require("ground")) {
    result.ground = read_reference(*node, "the ground", found).value_or(Name{});
  }
  if (const YamlNode* node = fields.require("bodies")) {
    result.bodies = read_bodies(*node, result.space, found);
  }
  if (const YamlNode* node = fields.require("couplings")) {
    result.couplings = read_couplings(*node, result.space, found);
  }
  if (const YamlNode* node = fields.find("actuators")) {
    result.actuators = read_actuators(*node, found);
  }
  if (const YamlNode* node = fields.find("cases")) {
    result.cases = read_cases(*node, found);
  }
  if (const YamlNode* node = fields.find("published")) {
    result.published = read_published(*node, found);
  }
}

}  // namespace

std::optional<MechanismDescription> read_mechanism(const YamlNode& root, Diagnostics& found) {
  const int errors_before = found.error_count();
  Fields fields(root, SourceRange{.line = 1, .column = 1, .length = 1}, "the mechanism", found);
  MechanismDescription result;
  read_version(fields, found);
  read_head(fields, result, found);
  read_sections(fields, result, found);
  pass_over(root, fields, found);
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace kinestat
