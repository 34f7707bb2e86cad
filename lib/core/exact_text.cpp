#include "core/exact_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/compile.h>

#include "core/contract.hpp"

namespace kinestat {

// fmt, with its format compiled and into a buffer, takes the time of std::to_chars; this has other
// exponents, as in 1e+05.
void append_exact(double value, std::string& text) {
  KINESTAT_EXPECTS(std::isfinite(value));
  if (value == 0.0) {
    text += "0.0";
    return;
  }
  char digits[kLongestExact];
  char* end = fmt::format_to(&digits[0], FMT_COMPILE("{}"), value);
  if (std::none_of(&digits[0], end, [](char c) { return c == '.' || c == 'e'; })) {
    *end++ = '.';
    *end++ = '0';
  }
  text.append(&digits[0], end);
}

}  // namespace kinestat
