#include "draw/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "draw/shades.hpp"

namespace kinestat {
namespace {

// Relative luminance of "#rrggbb" by WCAG 2.1.
double luminance(std::string_view colour) {
  const auto channel = [&](std::size_t at) {
    const double share = std::stoi(std::string(colour.substr(at, 2)), nullptr, 16) / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
}

double contrast(std::string_view a, std::string_view b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

class EveryInk : public testing::TestWithParam<Ink> {};

// WCAG 2.1, 1.4.11: graphics need a contrast of 3 to what is beside them.
TEST_P(EveryInk, StandsOutFromThePaper) {
  EXPECT_GE(contrast(light_value(GetParam()), light_value(Ink::paper)), 3.0);
  EXPECT_GE(contrast(dark_value(GetParam()), dark_value(Ink::paper)), 3.0);
}

INSTANTIATE_TEST_SUITE_P(Palette,
                         EveryInk,
                         testing::Values(Ink::ink,
                                         Ink::soft,
                                         Ink::blue,
                                         Ink::vermilion,
                                         Ink::green,
                                         Ink::pink,
                                         Ink::brown,
                                         Ink::sky),
                         [](const auto& given) { return std::string(ink_name(given.param)); });

// WCAG 2.1, 1.4.3: text needs 4.5.
TEST(Palette, LetsTextBeRead) {
  for (const Ink ink : {Ink::ink, Ink::soft}) {
    for (const Ink behind : {Ink::paper, Ink::tint}) {
      EXPECT_GE(contrast(light_value(ink), light_value(behind)), 4.5) << ink_name(ink);
      EXPECT_GE(contrast(dark_value(ink), dark_value(behind)), 4.5) << ink_name(ink);
    }
  }
}

TEST(Palette, TellsSeriesApartByInkAndDash) {
  std::set<std::pair<Ink, std::string>> looks;
  for (int series = 0; series < 24; ++series) {
    looks.insert({series_ink(series), std::string(series_dash(series))});
  }
  EXPECT_EQ(looks.size(), 24U);
}

TEST(Palette, GivesNeighboursDifferentDashes) {
  for (int series = 0; series < 5; ++series) {
    EXPECT_NE(series_dash(series), series_dash(series + 1));
  }
}

// CIE lightness of "#rrggbb" over a paper, as programs blend: channel by channel.
double lightness(std::string_view colour, std::string_view paper, double opacity) {
  std::string mixed = "#";
  for (const std::size_t at : {1U, 3U, 5U}) {
    const auto channel = [at](std::string_view of) {
      return std::stoi(std::string(of.substr(at, 2)), nullptr, 16);
    };
    const double value = opacity * channel(colour) + (1.0 - opacity) * channel(paper);
    constexpr std::string_view kDigits = "0123456789abcdef";
    const auto whole = static_cast<std::size_t>(std::lround(value));
    mixed += kDigits[whole / 16];
    mixed += kDigits[whole % 16];
  }
  return 116.0 * std::cbrt(luminance(mixed)) - 16.0;
}

// By lightness alone, which every eye sees: five units of it are told apart at once.
TEST(Palette, ShadesAreAsFarApartAsEyesAsk) {
  constexpr int kSteps = 8;
  for (const auto& value : {light_value, dark_value}) {
    double before = lightness(value(Ink::blue), value(Ink::paper), 0.0);
    double sense = 0.0;
    for (int step = 0; step < kSteps; ++step) {
      const double one =
          lightness(value(Ink::blue), value(Ink::paper), shade_opacity(step, kSteps));
      sense = step == 0 ? std::copysign(1.0, one - before) : sense;
      EXPECT_GT(sense * (one - before), step == 0 ? 2.0 : 5.0) << step;
      before = one;
    }
  }
}

TEST(Palette, DeclaresEveryVariableThatItsRulesUse) {
  const std::string rules = ink_rules();
  const std::string light = light_variables();
  const std::string dark = dark_variables();
  for (std::size_t at = rules.find("var("); at != std::string::npos;
       at = rules.find("var(", at + 1)) {
    const std::string name = rules.substr(at + 4, rules.find(')', at) - at - 4);
    EXPECT_NE(light.find(name + ":#"), std::string::npos) << name;
    EXPECT_NE(dark.find(name + ":#"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace kinestat
