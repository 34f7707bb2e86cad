#include "io/yaml_tree.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "io/byte_scan.hpp"
#include "io/cut_value.hpp"
#include "io/internal/parser_words.hpp"
#include "io/internal/structure_scan.hpp"
#include "io/internal/tree_builder.hpp"

namespace kinestat {

namespace {

// yaml-cpp recurses, and gives up at 500 levels.
constexpr int kDeepest = 400;

constexpr const char* kFirstLines =
    "a mechanism file begins with 'kinestat: 1' and continues with 'key: value' lines";

void parse(const YamlText& text, TreeBuilder& builder) {
  std::istringstream stream(text.all());
  YAML::Parser parser(stream);
  // A second document makes the builder stop; there is no need to ask for a third.
  if (parser.HandleNextDocument(builder)) {
    parser.HandleNextDocument(builder);
  }
}

void check_root(const std::optional<YamlNode>& root, Diagnostics& found) {
  if (!root || root->kind == YamlKind::null) {
    found.error("E0205", {}, "empty document", kFirstLines);
    return;
  }
  if (root->kind == YamlKind::mapping) {
    return;
  }
  const bool is_list = root->kind == YamlKind::sequence;
  const bool lacks_space = !is_list && !root->quoted && root->text.find(':') != std::string::npos;
  found.error("E0304",
              root->where,
              fmt::format("expected a mapping, found a {}", is_list ? "list" : "single value"),
              lacks_space ? "write a space after the ':' of each key" : kFirstLines);
}

}  // namespace

// Every mapping is asked for all keys that it may have: their first letters tell most apart.
const YamlNode* YamlNode::find(std::string_view key) const {
  const char first = key.empty() ? '\0' : key.front();
  for (const YamlEntry& entry : entries) {
    if (entry.key[0] == first && entry.key == key) {
      return &entry.value;
    }
  }
  return nullptr;
}

bool is_truth_value(const YamlNode& node) {
  if (node.kind != YamlKind::scalar || node.quoted) {
    return false;
  }
  const std::string_view text = node.text;
  return text.starts_with('t') ? text == "true" : text.starts_with('f') && text == "false";
}

std::optional<YamlNode> read_yaml(const SourceFile& source,
                                  const ReadLimits& limits,
                                  Diagnostics& found) {
  ReadLimits used = limits;
  used.depth = std::min(limits.depth, kDeepest);
  if (!scan_bytes(source, found)) {
    return {};
  }
  SourceMap map(source.text);
  if (!scan_structure(map, used, found)) {
    return {};
  }
  const int errors_before = found.error_count();
  TreeBuilder builder(map, used, found);
  try {
    parse(map.text(), builder);
  } catch (const YAML::Exception& exception) {
    report_parser_error(exception, map, builder.last_long_quote(), found);
  } catch (const TreeBuilder::Stop&) {
    // The builder has said why.
  }
  if (found.error_count() > errors_before) {
    return {};
  }
  std::optional<YamlNode> root = builder.take_root();
  check_root(root, found);
  if (root) {
    report_decimal_commas(*root, found);
  }
  return found.error_count() > errors_before ? std::nullopt : std::move(root);
}

}  // namespace kinestat
