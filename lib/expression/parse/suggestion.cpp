#include "expression/parse/suggestion.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "core/spelling.hpp"
#include "core/text.hpp"
#include "expression/functions.hpp"
#include "expression/units.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kWholeList = 64;

struct Spelling {
  std::string_view word;
  std::string_view unit;
};

constexpr auto kSpellings = std::to_array<Spelling>({
    {"degree", "deg"},    {"radian", "rad"},    {"revolution", "rev"}, {"turn", "rev"},
    {"meter", "m"},       {"metre", "m"},       {"millimeter", "mm"},  {"millimetre", "mm"},
    {"micrometre", "um"}, {"centimetre", "cm"}, {"kilometre", "km"},   {"inch", "in"},
    {"second", "s"},      {"minute", "min"},    {"hour", "h"},         {"gram", "g"},
    {"kilogram", "kg"},   {"newton", "N"},      {"kilonewton", "kN"},  {"watt", "W"},
    {"kilowatt", "kW"},   {"mNm", "N*mm"},      {"Nmm", "N*mm"},       {"kNm", "kN*m"},
    {"foot", "ft"},       {"feet", "ft"},       {"pound", "lb"},       {"joule", "J"},
    {"pascal", "Pa"},     {"hertz", "Hz"},      {"millisecond", "ms"}, {"horsepower", "hp"},
});

// Units of everyday use that are none here.
constexpr auto kForeignUnits = std::to_array<Spelling>({
    {"mN", "0.001 N"},
    {"MN", "1000 kN"},
    {"kPa", "1000 Pa"},
    {"GPa", "1000 MPa"},
    {"bar", "0.1 MPa"},
    {"kHz", "1000 Hz"},
    {"mrad", "0.001 rad"},
    {"oz", "1/16 lb"},
    {"yd", "3 ft"},
    {"mil", "0.001 in"},
    {"ksi", "1000 psi"},
    {"rps", "1 rev/s"},
    {"krpm", "1000 rpm"},
    {"upm", "1 rpm"},
    {"kph", "1 km/h"},
    {"t", "1000 kg"},
    {"MW", "1000 kW"},
    {"U", "1 rev, and 1 U/min is 1 rpm"},
    {"tr", "1 rev, and 1 tr/min is 1 rpm"},
    {"PS", "735.49875 W"},
    {"kp", "1 kgf"},
    {"Grad", "1 deg"},
    {"grad", "0.9 deg"},
    {"gon", "0.9 deg"},
});

// A unit written out, in the plural, or broken off after three letters or more.
std::string_view spelled_unit(std::string_view word) {
  const auto* const row = std::ranges::find_if(kSpellings, [word](const Spelling& spelling) {
    return word.size() >= 3 && (spelling.word.starts_with(word) ||
                                (word.starts_with(spelling.word) && word.ends_with('s')));
  });
  return row != kSpellings.end() ? row->unit : std::string_view();
}

bool differ_in_case_only(std::string_view a, std::string_view b) {
  return in_small_letters(a) == in_small_letters(b);
}

// Names of one or two letters are one step from each other: short words are near only if they
// differ in case.
std::string near_word(std::string_view word, std::span<const std::string> words) {
  const auto same = std::ranges::find_if(
      words, [word](const std::string& other) { return differ_in_case_only(word, other); });
  if (same != words.end()) {
    return fmt::format("did you mean '{}'?", *same);
  }
  return word.size() < 3 ? std::string() : did_you_mean(word, words);
}

}  // namespace

std::string unit_hint(std::string_view word) {
  if (const std::string_view unit = spelled_unit(word); !unit.empty()) {
    return fmt::format("did you mean '{}'?", unit);
  }
  const auto* const foreign = std::ranges::find(kForeignUnits, word, &Spelling::word);
  if (foreign != kForeignUnits.end()) {
    return fmt::format("1 {} is {}", word, foreign->unit);
  }
  const std::string near = near_word(word, unit_names());
  return near.empty() ? fmt::format("units are {}", plain_list(unit_names(), kWholeList)) : near;
}

std::string name_hint(std::string_view word, std::span<const std::string> known) {
  std::string near = did_you_mean(word, known);
  if (!near.empty()) {
    return near;
  }
  std::vector<std::string> words(function_names().begin(), function_names().end());
  words.insert(words.end(), unit_names().begin(), unit_names().end());
  words.emplace_back("pi");
  return near_word(word, words);
}

std::string function_hint(std::string_view word) {
  const std::string near = near_word(word, function_names());
  return near.empty() ? fmt::format("functions are {}", plain_list(function_names(), kWholeList))
                      : near;
}

}  // namespace kinestat
