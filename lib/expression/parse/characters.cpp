#include "expression/parse/characters.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "core/utf8.hpp"

namespace kinestat {

namespace {

struct Advice {
  char32_t value = 0;
  std::string_view hint;
};

// In the order of the code points.
constexpr auto kAdvice = std::to_array<Advice>({
    {0x00A0, "write an ordinary space"},
    {0x00AD, "remove this invisible character"},
    {0x00B1, "write one value: a tolerance has no place here"},
    {0x00B2, "write ^2"},
    {0x00B3, "write ^3"},
    {0x00B5, "write um for micrometres"},
    {0x00B7, "write *"},
    {0x00B9, "write ^1"},
    {0x00BA, "write deg for degrees"},
    {0x00BC, "write 1/4"},
    {0x00BD, "write 1/2"},
    {0x00BE, "write 3/4"},
    {0x00D7, "write *"},
    {0x00F7, "write /"},
    {0x03BC, "write um for micrometres"},
    {0x03C0, "write pi"},
    {0x2009, "write an ordinary space"},
    {0x200B, "remove this invisible character"},
    {0x2010, "write -"},
    {0x2011, "write -"},
    {0x2012, "write -"},
    {0x2013, "write -"},
    {0x2014, "write -"},
    {0x2018, "write names without quotes"},
    {0x2019, "write names without quotes"},
    {0x201C, "write names without quotes"},
    {0x201D, "write names without quotes"},
    {0x2022, "write *"},
    {0x202F, "write an ordinary space"},
    {0x2030, "write 5/1000 for 5 per mille"},
    {0x2032, "write the unit by its name: 5/60 deg for minutes of arc"},
    {0x2033, "write the unit by its name: 5 in for inches, 5/3600 deg for seconds of arc"},
    {0x2044, "write /"},
    {0x207B, "write ^ and the exponent, such as s^-1"},
    {0x2212, "write -"},
    {0x2215, "write /"},
    {0x2217, "write *"},
    {0x221A, "write sqrt( )"},
    {0x2220, "write the angle alone, such as 30 deg"},
    {0x2260, "write !="},
    {0x2264, "write <="},
    {0x2265, "write >="},
    {0x22C5, "write *"},
    {0xFEFF, "remove this invisible character"},
});

std::string hint_for(char32_t value) {
  constexpr char32_t kFullWidth = 0xFEE0U;  // from an ASCII character to its wide form
  if (value > kFullWidth + ' ' && value <= kFullWidth + '~') {
    return fmt::format("write {}", static_cast<char>(value - kFullWidth));
  }
  const auto* const known = std::ranges::find(kAdvice, value, &Advice::value);
  return known != kAdvice.end()
             ? std::string(known->hint)
             : std::string("names are made of the letters A-Z and a-z, digits and '_'");
}

ExpressionError foreign(std::string_view text, std::size_t at) {
  const Character found = character_at(text, at);
  ExpressionError error{
      .offset = static_cast<int>(at),
      .length = std::max(static_cast<int>(found.size), 1),
      .code = "E0308",
      .message = fmt::format("byte 0x{:02X} is not UTF-8 text", static_cast<unsigned>(found.code)),
      .hint = "save the file as UTF-8"};
  if (found.size > 0) {
    error.message = fmt::format("character {} is not allowed in an expression",
                                foreign_character(text.substr(at, found.size)));
    error.hint = hint_for(found.code);
  }
  return error;
}

}  // namespace

std::string without(std::string_view text, char unwanted) {
  std::string result(text);
  std::erase(result, unwanted);
  return result;
}

std::optional<ExpressionError> find_foreign_character(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool is_degree = text.substr(at).starts_with(kDegreeSign);
    if (!is_degree && (text[at] < ' ' || text[at] > '~') && !is_space(text[at])) {
      return foreign(text, at);
    }
    at += is_degree ? kDegreeSign.size() - 1 : 0;
  }
  return std::nullopt;
}

}  // namespace kinestat
