#include "draw/palette.hpp"

#include <array>

#include <fmt/format.h>

#include "core/contract.hpp"

namespace kinestat {

namespace {

struct InkRow {
  std::string_view name;
  std::string_view light;
  std::string_view dark;
};

// In the order of the enumeration. Lines and text have a contrast of at least 3 to the paper, text
// of at least 4.5. The six of the series differ, for each of the four kinds of colour vision
// (Machado 2009), by at least 17 (light) and 11 (dark) in CIE Lab; dashes and markers do the rest.
constexpr std::array<InkRow, 12> kInks = {{
    {"none", "none", "none"},
    {"paper", "#ffffff", "#14181d"},
    {"ink", "#1b1f24", "#e8eaed"},
    {"soft", "#5a6572", "#a3aebb"},
    {"grid", "#d5dae0", "#3b444e"},
    {"tint", "#f0f3f6", "#222931"},
    {"blue", "#0060ad", "#5a9cf5"},
    {"vermilion", "#d95f02", "#ff8a4c"},
    {"green", "#00875a", "#1fbf8f"},
    {"pink", "#c2649a", "#f2a7da"},
    {"brown", "#6b3e0a", "#e8d26a"},
    {"sky", "#3a9bd9", "#9ad8ff"},
}};

constexpr std::array<std::string_view, 4> kDashes = {"", "7 3", "2 2.5", "9 3 2 3"};

const InkRow& row(Ink ink) {
  return kInks.at(static_cast<std::size_t>(ink));
}

std::string variables(std::string_view InkRow::*value) {
  std::string text;
  for (std::size_t i = 1; i < kInks.size(); ++i) {
    text += fmt::format("--ks-{}:{};", kInks[i].name, kInks[i].*value);
  }
  return text;
}

}  // namespace

Ink series_ink(int series) {
  KINESTAT_EXPECTS(series >= 0);
  return static_cast<Ink>(static_cast<int>(Ink::blue) + series % kSeriesInks);
}

std::string_view series_dash(int series) {
  KINESTAT_EXPECTS(series >= 0);
  // Another dash for the next series and, when the inks begin again, for the same ink.
  const int turn = series / kSeriesInks;
  return kDashes[static_cast<std::size_t>(series + turn) % kDashes.size()];
}

std::string_view light_value(Ink ink) {
  return row(ink).light;
}

std::string_view dark_value(Ink ink) {
  return row(ink).dark;
}

std::string_view ink_name(Ink ink) {
  return row(ink).name;
}

std::string ink_rules() {
  std::string text;
  for (std::size_t i = 1; i < kInks.size(); ++i) {
    text += fmt::format(".ks-f-{0}{{fill:var(--ks-{0})}}.ks-s-{0}{{stroke:var(--ks-{0})}}",
                        kInks[i].name);
  }
  return text;
}

std::string light_variables() {
  return variables(&InkRow::light);
}

std::string dark_variables() {
  return variables(&InkRow::dark);
}

}  // namespace kinestat
