// Tables of comma-separated values by RFC 4180, with LF line ends.
#pragma once

#include <span>
#include <string>

namespace kinestat {

/// One line; cells with a comma, a quote or a line end are quoted.
std::string csv_line(std::span<const std::string> cells);

}  // namespace kinestat
