// From the events of yaml-cpp's parser to our tree.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/mark.h>

#include "core/diagnostic.hpp"
#include "io/internal/source_map.hpp"
#include "io/read_file.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Collects one document. Nodes are kept once and referred to by number, so that aliases share them
/// and a file of aliases to aliases is counted, and refused, before anything is copied.
class TreeBuilder : public YAML::EventHandler {
 public:
  /// Thrown out of the parser after an error behind which nothing can be understood.
  struct Stop {};

  TreeBuilder(SourceMap& map, const ReadLimits& limits, Diagnostics& found);

  /// The root with all aliases expanded; empty if no node came. Only without errors, and once:
  /// where nothing is shared the nodes move, so that a large file is never held twice.
  std::optional<YamlNode> take_root();

  /// The last quoted text of several lines, of which a quote may be missing; else line 0.
  SourceRange last_long_quote() const { return last_long_quote_; }

  void OnDocumentStart(const YAML::Mark& mark) override;

  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnScalar(const YAML::Mark& mark,
                const std::string& tag,
                YAML::anchor_t anchor,
                const std::string& value) override;

  void OnSequenceStart(const YAML::Mark& mark,
                       const std::string&,
                       YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override {
    start_collection(YamlKind::sequence, mark, anchor, style);
  }

  void OnSequenceEnd() override { end_collection(); }

  void OnMapStart(const YAML::Mark& mark,
                  const std::string&,
                  YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override {
    start_collection(YamlKind::mapping, mark, anchor, style);
  }

  void OnMapEnd() override { end_collection(); }

 private:
  struct Child {
    std::size_t part = 0;
    std::string key;
    SourceRange key_where;
  };

  // A node whose children are numbers of other parts, and what it becomes when expanded.
  struct Part {
    YamlNode node;
    std::vector<Child> children;
    std::size_t bytes = 0;  // of text
    int size = 1;           // nodes
    int height = 0;         // collections on the longest way down, itself counted
    bool is_open = false;
  };

  // A collection that has begun.
  struct Frame {
    std::size_t part = 0;
    bool is_block = false;
    bool awaits_key = false;
    bool is_key_usable = false;
    std::size_t key_offset = 0;  // as the parser marked it
    Child key;
    std::unordered_map<std::string, SourceRange> seen;  // of a long mapping
  };

  std::size_t add_part(YamlKind kind, SourceRange where, YAML::anchor_t anchor);
  void start_collection(YamlKind kind,
                        const YAML::Mark& mark,
                        YAML::anchor_t anchor,
                        YAML::EmitterStyle::value style);
  void end_collection();
  void check_quote(std::size_t begin, SourceRange where);
  void check_text(const YamlNode& node, std::size_t begin);
  void attach(std::size_t part, SourceRange where, std::size_t mark);
  void take_key(Frame& frame, const YamlNode& key, SourceRange where);
  std::optional<SourceRange> find_key(Frame& frame, const std::string& key) const;
  void take_child(Frame& frame, std::size_t part);
  std::size_t skip_properties(std::size_t mark);
  void count(int nodes, std::size_t bytes, SourceRange where);
  void check_depth(int height, SourceRange where);
  template <class ChildOf>
  static YamlNode assembled(Part part, const ChildOf& child_of);
  YamlNode expand(std::size_t number) const;
  YamlNode take(std::size_t number);
  Diagnostic& refuse(std::string_view code,
                     SourceRange where,
                     std::string message,
                     std::string hint);

  bool awaits_key() const { return !frames_.empty() && frames_.back().awaits_key; }

  SourceMap& map_;
  const ReadLimits& limits_;
  Diagnostics& found_;
  std::deque<Part> parts_;  // never copied while it grows
  std::size_t taken_ = 0;   // how many have been taken from its front
  std::vector<Frame> frames_;
  std::unordered_map<YAML::anchor_t, std::size_t> anchors_;
  int documents_ = 0;
  int nodes_ = 0;
  int errors_ = 0;
  std::size_t alias_bytes_ = 0;
  std::size_t last_tag_ = std::string::npos;
  SourceRange last_long_quote_;
};

}  // namespace kinestat
