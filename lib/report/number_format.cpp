#include "report/number_format.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/contract.hpp"

namespace kinestat {

std::string format_exact(double value) {
  KINESTAT_EXPECTS(std::isfinite(value));
  if (value == 0.0) {
    return "0.0";
  }
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) {
    text += ".0";
  }
  return text;
}

std::string format_short(double value) {
  KINESTAT_EXPECTS(std::isfinite(value));
  return value == 0.0 ? "0" : fmt::format("{:.6g}", value);
}

}  // namespace kinestat
