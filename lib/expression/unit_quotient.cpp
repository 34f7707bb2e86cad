#include "expression/unit_quotient.hpp"

namespace kinestat {

std::string unit_quotient(std::string_view above, std::string_view below) {
  if (below.empty()) {
    return std::string(above);
  }
  const bool is_compound = below.find_first_of("*/") != std::string_view::npos;
  std::string text(above.empty() ? "1" : above);
  text += '/';
  return is_compound ? text.append("(").append(below).append(")") : text.append(below);
}

}  // namespace kinestat
