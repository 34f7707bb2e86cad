#include "report/csv.hpp"

namespace kinestat {

std::string csv_line(std::span<const std::string> cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += i == 0 ? "" : ",";
    if (cells[i].find_first_of(",\"\r\n") == std::string::npos) {
      line += cells[i];
      continue;
    }
    line += '"';
    for (const char c : cells[i]) {
      line.append(c == '"' ? 2 : 1, c);
    }
    line += '"';
  }
  return line + "\n";
}

}  // namespace kinestat
