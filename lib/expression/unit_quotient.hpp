// Units of one quantity by another.
#pragma once

#include <string>
#include <string_view>

namespace kinestat {

/// "N*m/mm", "rad/s/(mm/s)"; of a plain number "1/mm", by one the unit itself. As programs read it
/// that calculate with units.
std::string unit_quotient(std::string_view above, std::string_view below);

}  // namespace kinestat
