#include "format/mechanism_reader.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/version.hpp"
#include "description/cable_expansion.hpp"
#include "description/gear_expansion.hpp"
#include "format/sections/sections.hpp"
#include "io/body_reader.hpp"
#include "io/cable_reader.hpp"
#include "io/coupling_reader.hpp"
#include "io/fields.hpp"
#include "io/gear_reader.hpp"
#include "io/parameter_reader.hpp"
#include "io/synthesis_reader.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

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
}

// Empty after an error: then nobody can tell how many coordinates a point needs.
std::optional<Space> read_space(Fields& fields, Diagnostics& found) {
  const YamlNode* node = fields.find("space");
  if (node == nullptr) {
    return Space::spatial;
  }
  static const std::vector<std::string> kSpaces = {"planar", "spatial"};
  const auto word = read_word(*node, "the space", kSpaces, found);
  return word ? std::optional(*word == 0 ? Space::planar : Space::spatial) : std::nullopt;
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

// Reads one mechanism file section by section.
class MechanismReader {
 public:
  MechanismReader(const YamlNode& root, Diagnostics& found)
      : root_(root),
        fields_(root, SourceRange{.line = 1, .column = 1, .length = 1}, "the mechanism", found),
        found_(found) {}

  MechanismDescription read() {
    read_version(fields_, found_);
    read_head(fields_, result_, found_);
    read_plain_sections();
    const std::optional<Space> space = read_space(fields_, found_);
    if (space) {
      result_.space = *space;
      read_structure();
      read_sections_in_space();
    } else {
      pass_over_sections_in_space();
    }
    file_sections().read_keys(fields_, file(space), result_);
    read_tasks();
    fields_.ignore_prefix("x-");  // the user's own notes
    fields_.finish();
    return std::move(result_);
  }

 private:
  FileValue file(std::optional<Space> space) const {
    return {.node = root_,
            .what = "",
            .key = nullptr,
            .owner = "",
            .where = fields_.where(),
            .place = fields_.where(),
            .space = space,
            .found = found_};
  }

  // Calls `read` with the section's value, if it is there.
  template <class Read>
  void section(std::string_view key, const Read& read) {
    if (const YamlNode* node = fields_.find(key)) {
      read(*node);
    }
  }

  // Likewise for a section that remembers where it begins: at its key.
  template <class Description, class Read>
  void section(std::string_view key, std::optional<Description>& target, const Read& read) {
    section(key, [&](const YamlNode& node) {
      target = read(node);
      if (target) {
        target->where = place_of(key);
      }
    });
  }

  SourceRange place_of(std::string_view key) const {
    return std::ranges::find(root_.entries, key, &YamlEntry::key)->key_where;
  }

  void read_plain_sections() {
    section("units", [&](const YamlNode& node) { read_units(node, result_.units, found_); });
    section("parameters",
            [&](const YamlNode& node) { result_.parameters = read_parameters(node, found_); });
    section("tree", [&](const YamlNode& node) {
      result_.tree_where = node.where;
      result_.tree = read_references(node, "the tree", found_);
    });
    section("order", [&](const YamlNode& node) { read_order(node, result_, found_); });
  }

  // A file may hold a synthesis task and no mechanism; then none of these keys may stand alone.
  void read_structure() {
    const bool may_lack = root_.find("synthesis") != nullptr && root_.find("ground") == nullptr &&
                          root_.find("bodies") == nullptr && root_.find("couplings") == nullptr;
    const auto find = [&](std::string_view key) {
      return may_lack ? fields_.find(key) : fields_.require(key);
    };
    if (const YamlNode* node = find("ground")) {
      const std::optional<Name> ground = read_reference(*node, "the ground", found_);
      if (ground && check_name(*ground, "the ground", found_)) {
        result_.ground = *ground;
      }
    }
    if (const YamlNode* node = find("bodies")) {
      result_.bodies = read_bodies(*node, result_.space, found_);
    }
    if (const YamlNode* node = find("couplings")) {
      result_.couplings = read_couplings(*node, result_.space, found_);
    }
  }

  void read_sections_in_space() {
    section("cables", [&](const YamlNode& node) {
      result_.cables_where = place_of("cables");
      result_.cables = read_cables(node, result_.space, found_);
    });
  }

  void pass_over_sections_in_space() {
    for (const char* key : {"ground", "bodies", "couplings", "cables"}) {
      (void)fields_.find(key);
    }
  }

  void read_tasks() {
    section("gears", result_.gears, [&](const YamlNode& node) { return read_gears(node, found_); });
    section("synthesis", result_.synthesis, [&](const YamlNode& node) {
      return read_synthesis(node, found_);
    });
  }

  const YamlNode& root_;
  Fields fields_;
  Diagnostics& found_;
  MechanismDescription result_;
};

}  // namespace

std::optional<MechanismDescription> read_mechanism(const YamlNode& root, Diagnostics& found) {
  const int errors_before = found.error_count();
  MechanismDescription result = MechanismReader(root, found).read();
  if (found.error_count() == errors_before) {
    expand_gears(result);
    expand_cables(result);
  }
  return found.error_count() == errors_before ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace kinestat
