// Cells of tables that are compared, with complaints at their lines.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/csv_reader.hpp"
#include "core/diagnostic.hpp"
#include "studies/compare/compare_values.hpp"

namespace kinestat {

/// A file that is no table at all would have an error in every line.
inline constexpr int kMostTableErrors = 20;

/// Adds E0903 at the line; 0 is the whole file.
void refuse_line(int line, std::string message, std::string hint, Diagnostics& found);

/// The number of a cell, in any locale; empty, with E0903, if it is no finite number and nothing
/// else.
std::optional<double> read_cell(std::string_view text, int line, Diagnostics& found);

/// The column with the name of the mechanism or, of one without a name, the path of its file.
inline constexpr const char* kMechanismColumn = "mechanism";

/// What two tables have in common there: paths are not compared.
std::string compared_name(const std::string& mechanism);

/// The head of a column of numbers: "C1 [N*m]".
struct ColumnTitle {
  std::string name;
  ValueUnit unit;
};

/// Empty, with E0903, if the unit is none.
std::optional<ColumnTitle> read_title(const std::string& text, int line, Diagnostics& found);

}  // namespace kinestat
