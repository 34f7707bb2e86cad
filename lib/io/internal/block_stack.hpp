// The block lists and mappings that are open at a place of a YAML text.
#pragma once

#include <vector>

namespace kinestat {

enum class Block { list, mapping };

/// Blocks are told apart by the column, in bytes from 0, in which their entries begin.
class BlockStack {
 public:
  /// Of the innermost block; -1 without one.
  int column() const { return blocks_.empty() ? -1 : blocks_.back().column; }

  void clear() { blocks_.clear(); }

  /// An entry in this column opens a block unless it belongs to the innermost one. The items of a
  /// list may stand in the column of the mapping around it.
  void open(int at_column, Block kind) {
    const bool is_list_in_mapping = at_column == column() && kind == Block::list &&
                                    !blocks_.empty() && blocks_.back().kind == Block::mapping;
    if (at_column > column() || is_list_in_mapping) {
      blocks_.push_back({.column = at_column, .kind = kind});
    }
  }

  /// Something in this column ends the blocks that are indented further.
  void close_until(int at_column, Block kind) {
    while (!blocks_.empty()) {
      const Entry& top = blocks_.back();
      const bool ends_list = top.kind == Block::list && kind != Block::list;
      if (top.column < at_column || (top.column == at_column && !ends_list)) {
        return;
      }
      blocks_.pop_back();
    }
  }

 private:
  struct Entry {
    int column = -1;
    Block kind = Block::mapping;
  };

  std::vector<Entry> blocks_;
};

}  // namespace kinestat
