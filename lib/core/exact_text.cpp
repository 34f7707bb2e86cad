#include "core/exact_text.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/compile.h>

#include "core/contract.hpp"

namespace kinestat {

// fmt, with its format compiled and into a buffer, takes the time of std::to_chars; this has other
// exponents, as in 1e+05.
char* write_exact(double value, char* text) {
  KINESTAT_EXPECTS(std::isfinite(value));
  if (value == 0.0) {
    return std::ranges::copy(std::string_view("0.0"), text).out;
  }
  char* end = fmt::format_to(text, FMT_COMPILE("{}"), value);
  if (std::none_of(text, end, [](char c) { return c == '.' || c == 'e'; })) {
    *end++ = '.';
    *end++ = '0';
  }
  return end;
}

void append_exact(double value, std::string& text) {
  char digits[kLongestExact];
  text.append(&digits[0], write_exact(value, &digits[0]));
}

}  // namespace kinestat
