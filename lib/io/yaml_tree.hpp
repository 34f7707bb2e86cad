// A YAML document as an own tree in which every value knows its place.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "io/read_file.hpp"

namespace kinestat {

enum class YamlKind { null, scalar, sequence, mapping };

struct YamlEntry;

/// One value. An alias is replaced by a copy of what its anchor names; the places in the copy are
/// those of the original.
struct YamlNode {
  YamlKind kind = YamlKind::null;
  /// A scalar's text with its quotes (of several lines the first; of a block scalar its header);
  /// the first character of a collection. A null cites its key; in a list its own text, or the
  /// list's beginning where nothing is written.
  SourceRange where;
  std::string text;     ///< of a scalar, decoded
  bool quoted = false;  ///< quotes or a block scalar: never a number or a truth value
  /// Column of the first character of `text` where all of it stands one-to-one on the line of
  /// `where` (plain or quoted, without escapes or folding), else 0.
  int text_column = 0;
  std::vector<YamlNode> items;     ///< of a sequence
  std::vector<YamlEntry> entries;  ///< of a mapping, in the order of the file

  /// The value of a key, or null; only a mapping has any.
  const YamlNode* find(std::string_view key) const;
};

/// A key and its value.
struct YamlEntry {
  std::string key;
  SourceRange key_where;
  YamlNode value;
};

/// Whether it is true or false without quotes, which are no texts and no numbers; nothing else is a
/// truth value.
bool is_truth_value(const YamlNode& node);

/// The one document of a file, whose root is a mapping. What two YAML readers could understand
/// differently is refused: E0202 to E0210, and E0304 for another root. Empty iff an error was
/// added.
std::optional<YamlNode> read_yaml(const SourceFile& source,
                                  const ReadLimits& limits,
                                  Diagnostics& found);

}  // namespace kinestat
