#include "format/mechanism_reader.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/version.hpp"
#include "description/cable_expansion.hpp"
#include "description/gear_expansion.hpp"
#include "format/sections/sections.hpp"
#include "io/coupling_reader.hpp"
#include "io/fields.hpp"
#include "io/synthesis_reader.hpp"
#include "io/unit_reader.hpp"
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
    section("units", [&](const YamlNode& node) { read_units(node, result_.units, found_); });
    const std::optional<Space> space = read_space(fields_, found_);
    result_.space = space.value_or(Space::spatial);
    read_structure(space.has_value());
    file_sections().read_keys(fields_, file(space), result_);
    section("synthesis", result_.synthesis, [&](const YamlNode& node) {
      return read_synthesis(node, found_);
    });
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

  // A file may hold a synthesis task and no mechanism; then none of these keys may stand alone.
  // Couplings need the space.
  void read_structure(bool has_space) {
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
    (void)find("bodies");
    const YamlNode* couplings = find("couplings");
    if (couplings != nullptr && has_space) {
      result_.couplings = read_couplings(*couplings, result_.space, found_);
    }
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
