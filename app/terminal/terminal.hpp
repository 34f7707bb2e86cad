// What a terminal can show.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "files/outcome.hpp"

namespace kinestat::app {

enum class ColorChoice {
  automatic,  ///< on a terminal that shows them, unless NO_COLOR is set
  always,
  never
};

/// The words for them.
inline constexpr std::array<std::pair<std::string_view, ColorChoice>, 3> kColorChoices = {
    {{"auto", ColorChoice::automatic},
     {"always", ColorChoice::always},
     {"never", ColorChoice::never}}};

/// For a stream by its descriptor: as wide as the terminal behind it, without bounds elsewhere.
TextLayout layout_of(int descriptor, ColorChoice choice);

}  // namespace kinestat::app
