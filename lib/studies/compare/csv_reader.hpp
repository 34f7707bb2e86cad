// Comma-separated values from a file that may hold anything.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"

namespace kinestat {

struct CsvRow {
  int line = 0;  ///< where it begins, from 1
  std::vector<std::string> cells;
};

/// Reads row by row, by RFC 4180; lines may end with CR LF. The text must outlive it.
class CsvReader {
 public:
  explicit CsvReader(std::string_view text);

  /// The next row; empty at the end, or when a quote is not closed.
  std::optional<CsvRow> next();

  bool is_broken() const { return is_broken_; }

  int line() const { return line_; }

 private:
  bool take(char c);
  bool ends_line();
  std::string cell();
  std::string quoted();

  std::string_view rest_;
  int line_ = 1;
  bool is_broken_ = false;
};

/// A file that is no table at all would have an error in every line.
inline constexpr int kMostTableErrors = 20;

/// Adds E0903 at the line; 0 is the whole file.
void refuse_line(int line, std::string message, std::string hint, Diagnostics& found);

/// The number of a cell, in any locale; empty, with E0903, if it is no finite number and nothing
/// else.
std::optional<double> read_cell(std::string_view text, int line, Diagnostics& found);

}  // namespace kinestat
