// A table of text with aligned columns.
#pragma once

#include <string>
#include <vector>

#include "report/text_layout.hpp"

namespace kinestat {

/// The first column is aligned left, the others right; widths count characters, not bytes.
class Table {
 public:
  explicit Table(std::vector<std::string> head);

  void add(std::vector<std::string> row);

  bool is_empty() const { return rows_.empty(); }

  const std::vector<std::string>& head() const { return head_; }

  const std::vector<std::vector<std::string>>& rows() const { return rows_; }

  /// Every line begins with `indent`; no line ends with spaces. Where it is wider than the layout,
  /// its columns follow in several parts, an empty line between them, each with the first column.
  std::string text(const std::string& indent, const TextLayout& layout = {}) const;

 private:
  std::vector<std::string> head_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace kinestat
