// Units of one quantity by another.
#pragma once

#include <string>
#include <string_view>

namespace kinestat {

/// "N*m/mm", "N*s/(mm*kg)"; what is above and below cancels: "rad/mm" for rad/s by mm/s, empty for
/// like units. Of a plain number "1/mm", by one the unit itself. With one stroke, as programs read
/// it that calculate with units.
std::string unit_quotient(std::string_view above, std::string_view below);

}  // namespace kinestat
