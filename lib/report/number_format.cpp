#include "report/number_format.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/exact_text.hpp"

namespace kinestat {

std::string format_exact(double value) {
  std::string text;
  append_exact(value, text);
  return text;
}

std::string format_short(double value) {
  KINESTAT_EXPECTS(std::isfinite(value));
  return value == 0.0 ? "0" : fmt::format("{:.6g}", value);
}

}  // namespace kinestat
