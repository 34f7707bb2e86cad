// Any bytes as a mechanism file: read, understood and bound, or refused with a place.

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "format/mechanism_reader.hpp"
#include "fuzz/diagnostic_invariants.hpp"
#include "fuzz/require.hpp"
#include "io/yaml_tree.hpp"
#include "mechanism/bind/bind.hpp"

namespace kinestat::fuzz {

namespace {

// Inside a copy that an alias made, places are those of the original; they lie in the text as well.
void check_tree(const YamlNode& node, const LineLengths& lines) {
  require(lines.holds(node.where) && node.where.line > 0, "a value has a place", node.text);
  require(node.text_column == 0 || node.text_column >= node.where.column,
          "a text stands at its place",
          node.text);
  require(node.kind == YamlKind::sequence || node.items.empty(), "only a list has items");
  require(node.kind == YamlKind::mapping || node.entries.empty(), "only a mapping has entries");
  for (const YamlNode& item : node.items) {
    check_tree(item, lines);
  }
  std::set<std::string_view> keys;
  for (const YamlEntry& entry : node.entries) {
    require(lines.holds(entry.key_where) && entry.key_where.line > 0, "a key has a place");
    require(keys.insert(entry.key).second, "a key stands once", entry.key);
    check_tree(entry.value, lines);
  }
}

void check_file(const SourceFile& source) {
  const LineLengths lines(source.text);
  Diagnostics found;
  const std::optional<YamlNode> root = read_yaml(source, {}, found);
  check_diagnostics(found, lines);
  require(root.has_value() != found.has_errors(), "a tree comes iff there is no error");
  if (!root) {
    return;
  }
  require(root->kind == YamlKind::mapping, "the root is a mapping");
  check_tree(*root, lines);
  const std::optional<MechanismDescription> description = read_mechanism(*root, found);
  check_diagnostics(found, lines);
  require(description.has_value() != found.has_errors(), "a description comes iff no error");
  if (!description) {
    return;
  }
  const std::optional<Mechanism> mechanism = bind(*description, found);
  check_diagnostics(found, lines);
  require(!(mechanism && found.has_errors()), "no mechanism comes with an error");
  if (mechanism && bind_in_space(*description, found)) {
    require(!found.has_errors(), "no mechanism in space comes with an error");
  }
}

}  // namespace

}  // namespace kinestat::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  kinestat::fuzz::check_file({.path = "fuzz.yaml", .text = text});
  return 0;
}
