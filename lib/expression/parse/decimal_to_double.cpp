#include "expression/parse/decimal_to_double.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

#include "expression/parse/characters.hpp"

namespace kinestat {

namespace {

std::size_t skip_exponent(std::string_view text, std::size_t at) {
  const std::size_t sign = has(text, at + 1, "+-") ? 1 : 0;
  const bool is_exponent = has(text, at, "eE") && has_digit(text, at + 1 + sign);
  return is_exponent ? skip_digits(text, at + 1 + sign) : at;
}

bool has_nonzero_digit(std::string_view literal) {
  const std::string_view mantissa = literal.substr(0, literal.find_first_of("eE"));
  return mantissa.find_first_of("123456789") != std::string_view::npos;
}

// Where the first digit that is not zero stands, as a power of ten, decides between too large and
// too small, because from_chars reports both alike.
bool is_below_one(std::string_view literal) {
  const std::size_t mark = literal.find_first_of("eE");
  if (mark != std::string_view::npos) {
    return literal[mark + 1] == '-';
  }
  return literal.find('.') < literal.find_first_of("123456789");
}

}  // namespace

std::size_t end_of_decimal(std::string_view text, std::size_t at) {
  at = skip_digits(text, at);
  if (has(text, at, ".")) {
    const std::size_t after = skip_exponent(text, skip_digits(text, at + 1));
    const bool is_name_next = after == at + 1 && after < text.size() && is_name_start(text[after]);
    return is_name_next ? at : after;
  }
  return skip_exponent(text, at);
}

std::optional<double> double_of(std::string_view literal, double& out_of_range) {
  double value = 0.0;
  const auto [end, fault] = std::from_chars(literal.data(), literal.data() + literal.size(), value);
  if (fault == std::errc::result_out_of_range || std::isinf(value) ||
      (value == 0.0 && has_nonzero_digit(literal))) {
    out_of_range = is_below_one(literal) ? 0.0 : HUGE_VAL;
    return std::nullopt;
  }
  return value;
}

std::optional<double> read_plain_number(std::string_view text) {
  const std::size_t sign = has(text, 0, "+-") ? 1 : 0;
  const bool begins = has_digit(text, sign) || (has(text, sign, ".") && has_digit(text, sign + 1));
  const bool is_octal = has(text, sign, "0") && has_digit(text, sign + 1);
  if (!begins || is_octal || end_of_decimal(text, sign) != text.size()) {
    return std::nullopt;
  }
  double out_of_range = 0.0;
  const std::optional<double> value = double_of(text.substr(sign), out_of_range);
  return value && text[0] == '-' ? std::optional(0.0 - *value) : value;
}

}  // namespace kinestat
