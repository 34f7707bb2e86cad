#include "io/internal/tree_builder.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "io/internal/scalar_end.hpp"
#include "io/internal/scalar_place.hpp"
#include "io/internal/structure_words.hpp"

namespace kinestat {

namespace {

// More errors than this are one mistake that repeats itself.
constexpr int kMostErrors = 100;

constexpr std::string_view kMergeKey = "<<";

std::size_t offset_of(const YAML::Mark& mark) {
  return static_cast<std::size_t>(std::max(mark.pos, 0));
}

}  // namespace

TreeBuilder::TreeBuilder(SourceMap& map, const ReadLimits& limits, Diagnostics& found)
    : map_(map), limits_(limits), found_(found) {}

Diagnostic& TreeBuilder::refuse(std::string_view code,
                                SourceRange where,
                                std::string message,
                                std::string hint) {
  if (++errors_ > kMostErrors) {
    throw Stop();
  }
  return found_.error(code, where, std::move(message), std::move(hint));
}

void TreeBuilder::OnDocumentStart(const YAML::Mark& mark) {
  if (++documents_ > 1) {
    report_second_document(map_, offset_of(mark), parts_.front().node.where, found_);
    throw Stop();
  }
}

void TreeBuilder::OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) {
  const std::size_t at = offset_of(mark);
  const std::size_t begin = anchor == YAML::NullAnchor ? at : skip_properties(at);
  SourceRange where = map_.at(begin);
  if (!frames_.empty() && !awaits_key()) {
    const Frame& frame = frames_.back();
    const bool is_mapping = parts_[frame.part].node.kind == YamlKind::mapping;
    if (is_mapping && frame.is_block && at == frame.key_offset && map_.text()[at] != '?') {
      refuse("E0204",
             frame.key.key_where,
             fmt::format("'{}' has no ':' behind it", frame.key.key),
             "write 'key: value', or indent the line if it continues the value above");
    }
    const bool is_written = is_null_word(map_.text(), begin);
    if (is_mapping) {
      where = frame.key.key_where;
    } else if (!is_written) {
      where = parts_[frame.part].node.where;
    }
  }
  attach(add_part(YamlKind::null, where, anchor), where, at);
}

void TreeBuilder::OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) {
  const std::size_t at = offset_of(mark);
  const std::size_t end = map_.text().skip_word(at);
  const SourceRange where = map_.range(at, end);
  const std::size_t part = anchors_.at(anchor);
  if (parts_[part].is_open) {
    refuse("E0209",
           where,
           fmt::format("alias '{}' is inside what it names", map_.text().part(at, end)),
           "write the value out")
        .notes.push_back({parts_[part].node.where, "the anchored value begins here"});
    throw Stop();
  }
  count(parts_[part].size, parts_[part].bytes, where);
  check_depth(parts_[part].height, where);
  attach(part, where, at);
}

void TreeBuilder::OnScalar(const YAML::Mark& mark,
                           const std::string&,
                           YAML::anchor_t anchor,
                           const std::string& value) {
  const std::size_t begin = skip_properties(offset_of(mark));
  YamlNode node = make_scalar(map_, begin, value);
  if (value.size() > limits_.scalar) {
    refuse("E0210",
           node.where,
           fmt::format("value is {} bytes long, the limit is {}", value.size(), limits_.scalar),
           "check that its quote closes where you mean it to");
    throw Stop();
  }
  check_quote(begin, node.where);
  check_text(node, begin);
  const std::size_t part = add_part(YamlKind::scalar, node.where, anchor);
  parts_[part].bytes = value.size();
  parts_[part].node = std::move(node);
  attach(part, parts_[part].node.where, offset_of(mark));
}

// The scan of the structure should have found an open quote; yaml-cpp accepts one without a word.
void TreeBuilder::check_quote(std::size_t begin, SourceRange where) {
  if (!is_one_of(map_.text()[begin], "'\"")) {
    return;
  }
  const std::size_t end = find_quote_end(map_.text(), begin);
  if (end == std::string::npos) {
    report_open_quote(map_, begin, found_);
    throw Stop();
  }
  if (end > map_.line_end(begin)) {
    last_long_quote_ = where;
  }
}

// Escapes can smuggle in what the byte scan refuses; yaml-cpp makes broken UTF-8 of \N and \_.
void TreeBuilder::check_text(const YamlNode& node, std::size_t begin) {
  if (!node.quoted || !find_bad_character(node.text)) {
    return;
  }
  const Escape escape = find_bad_escape(map_.text(), begin);
  const std::size_t end = escape.begin + escape.size;
  refuse("E0203",
         map_.range(escape.begin, end),
         fmt::format("escape '{}' is not allowed in a text", map_.text().part(escape.begin, end)),
         "of control characters use only \\n and \\t; write any other character itself");
}

void TreeBuilder::start_collection(YamlKind kind,
                                   const YAML::Mark& mark,
                                   YAML::anchor_t anchor,
                                   YAML::EmitterStyle::value style) {
  const SourceRange where = map_.at(skip_properties(offset_of(mark)));
  check_depth(1, where);
  const std::size_t part = add_part(kind, where, anchor);
  parts_[part].is_open = true;
  parts_[part].height = 1;
  Frame frame;
  frame.part = part;
  frame.is_block = style == YAML::EmitterStyle::Block;
  frame.awaits_key = kind == YamlKind::mapping;
  frames_.push_back(std::move(frame));
}

void TreeBuilder::end_collection() {
  const std::size_t part = frames_.back().part;
  frames_.pop_back();
  parts_[part].is_open = false;
  attach(part, parts_[part].node.where, std::string::npos);
}

std::size_t TreeBuilder::add_part(YamlKind kind, SourceRange where, YAML::anchor_t anchor) {
  // A key is no value; there is one for each key.
  count(awaits_key() ? 0 : 1, 0, where);
  Part part;
  part.node.kind = kind;
  part.node.where = where;
  parts_.push_back(std::move(part));
  if (anchor != YAML::NullAnchor) {
    anchors_[anchor] = parts_.size() - 1;
  }
  return parts_.size() - 1;
}

void TreeBuilder::count(int nodes, std::size_t bytes, SourceRange where) {
  nodes_ += nodes;
  alias_bytes_ += bytes;
  if (nodes_ > limits_.nodes) {
    report_nodes(limits_, where, nodes > 1 ? Excess::by_alias : Excess::by_value, found_);
    throw Stop();
  }
  if (alias_bytes_ > limits_.bytes) {
    refuse("E0210",
           where,
           fmt::format("aliases repeat more than {} bytes of text", limits_.bytes),
           "shorten the text that is repeated");
    throw Stop();
  }
}

void TreeBuilder::check_depth(int height, SourceRange where) {
  if (static_cast<int>(frames_.size()) + height > limits_.depth) {
    report_depth(limits_, where, found_);
    throw Stop();
  }
}

// A finished node goes to its list, its key, or becomes a key.
void TreeBuilder::attach(std::size_t part, SourceRange where, std::size_t mark) {
  if (frames_.empty()) {
    return;
  }
  Frame& frame = frames_.back();
  if (frame.awaits_key) {
    frame.key_offset = mark;
    take_key(frame, parts_[part].node, where);
    // Nothing refers to it any more, unless by an anchor.
    if (anchors_.empty() && part + 1 == parts_.size()) {
      parts_.pop_back();
    }
    return;
  }
  take_child(frame, part);
}

void TreeBuilder::take_child(Frame& frame, std::size_t part) {
  Part& parent = parts_[frame.part];
  const bool is_mapping = parent.node.kind == YamlKind::mapping;
  frame.awaits_key = is_mapping;
  if (is_mapping && !frame.is_key_usable) {
    return;
  }
  const Part& child = parts_[part];
  parent.size += child.size;
  parent.bytes += child.bytes + frame.key.key.size();
  parent.height = std::max(parent.height, child.height + 1);
  frame.key.part = part;
  parent.children.push_back(std::exchange(frame.key, {}));
}

// Where a mapping has a key. Most are short; for a long one there is a table.
std::optional<SourceRange> TreeBuilder::find_key(Frame& frame, const std::string& key) const {
  constexpr std::size_t kLongestScan = 16;
  const std::vector<Child>& children = parts_[frame.part].children;
  if (children.size() <= kLongestScan) {
    const auto found = std::ranges::find(children, key, &Child::key);
    return found == children.end() ? std::nullopt : std::optional(found->key_where);
  }
  while (frame.seen.size() < children.size()) {
    const Child& child = children[frame.seen.size()];
    frame.seen.emplace(child.key, child.key_where);
  }
  const auto found = frame.seen.find(key);
  return found == frame.seen.end() ? std::nullopt : std::optional(found->second);
}

void TreeBuilder::take_key(Frame& frame, const YamlNode& key, SourceRange where) {
  frame.awaits_key = false;
  frame.is_key_usable = false;
  frame.key = {.part = 0, .key = key.text, .key_where = where};
  if (key.kind != YamlKind::scalar) {
    const bool is_null = key.kind == YamlKind::null;
    refuse("E0208",
           where,
           is_null ? "a key is missing or null" : "a list or mapping cannot be a key",
           is_null ? "write a name before the ':', in quotes if it is 'null' or '~'"
                   : "write a plain name before the ':'");
    return;
  }
  if (key.text == kMergeKey && !key.quoted) {
    refuse("E0208",
           where,
           "merge key '<<' is not supported",
           "repeat the entries, or name the whole mapping by an alias");
    return;
  }
  if (const std::optional<SourceRange> first = find_key(frame, key.text)) {
    refuse(
        "E0207", where, fmt::format("key '{}' is given twice", key.text), "remove one of the two")
        .notes.push_back({*first, "first given here"});
    return;
  }
  frame.is_key_usable = true;
}

// Behind anchor and tag, of which the parser marks the first; tags are refused on the way.
std::size_t TreeBuilder::skip_properties(std::size_t mark) {
  const YamlText& text = map_.text();
  std::size_t at = mark;
  while (is_one_of(text[at], "&!")) {
    const std::size_t end = text.skip_word(at);
    if (text[at] == '!' && (last_tag_ == std::string::npos || at > last_tag_)) {
      last_tag_ = at;
      refuse("E0208",
             map_.range(at, end),
             fmt::format("tag '{}' is not supported", text.part(at, end)),
             "remove the tag; quote a text that begins with '!'");
    }
    at = end;
    while (text.is_space(at) || text[at] == '#') {
      at = text[at] == '#' ? text.skip_line(at) : at + 1;
    }
  }
  return at;
}

// Adds the children of a part, each as `child_of` makes it.
template <class ChildOf>
YamlNode TreeBuilder::assembled(Part part, const ChildOf& child_of) {
  YamlNode node = std::move(part.node);
  const bool is_mapping = node.kind == YamlKind::mapping;
  (is_mapping ? node.entries.reserve(part.children.size())
              : node.items.reserve(part.children.size()));
  for (Child& child : part.children) {
    if (is_mapping) {
      node.entries.push_back({.key = std::move(child.key),
                              .key_where = child.key_where,
                              .value = child_of(child.part)});
    } else {
      node.items.push_back(child_of(child.part));
    }
  }
  return node;
}

YamlNode TreeBuilder::expand(std::size_t number) const {
  return assembled(parts_[number], [this](std::size_t child) { return expand(child); });
}

// Numbers rise along the tree: what stands before a part is in the tree by then, or was a key.
YamlNode TreeBuilder::take(std::size_t number) {
  while (taken_ < number) {
    parts_.pop_front();
    ++taken_;
  }
  return assembled(std::move(parts_.front()), [this](std::size_t child) { return take(child); });
}

std::optional<YamlNode> TreeBuilder::take_root() {
  if (parts_.empty()) {
    return std::nullopt;
  }
  return anchors_.empty() ? take(0) : expand(0);
}

}  // namespace kinestat
