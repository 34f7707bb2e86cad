// Tables of comma-separated values by RFC 4180, with LF line ends.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kinestat {

/// Quoted if it has a comma, a quote or a line end.
void append_csv_cell(std::string_view cell, std::string& text);

void append_csv_line(std::span<const std::string_view> cells, std::string& text);

std::string csv_line(std::span<const std::string> cells);

}  // namespace kinestat
