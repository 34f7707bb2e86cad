// Comma-separated values from a file that may hold anything.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kinestat {

struct CsvRow {
  int line = 0;  ///< where it begins, from 1
  std::vector<std::string> cells;
};

/// A cell without blanks around it.
std::string_view trimmed(std::string_view cell);

/// "semicolons" or "tabs" where these stand between the names of a head; else empty.
std::string_view other_separators(const CsvRow& head);

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

}  // namespace kinestat
