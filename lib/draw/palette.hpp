// Colours, dashes and markers of all pictures: told apart by eyes of any kind, and without colour.
#pragma once

#include <string>
#include <string_view>

namespace kinestat {

/// What a colour is for; each has a value for light and one for dark pages.
enum class Ink {
  none,       ///< nothing is painted
  paper,      ///< the background
  ink,        ///< text and what matters most
  soft,       ///< text of second rank, axes
  grid,       ///< lines behind data
  tint,       ///< areas behind data
  blue,       ///< first series
  vermilion,  ///< second series
  green,
  pink,
  brown,
  sky
};

inline constexpr int kSeriesInks = 6;

/// The ink of the n-th series; after `kSeriesInks` of them they begin again, with another dash.
Ink series_ink(int series);

/// The pattern of the n-th series' line, "" for a full line, else dashes and gaps in pixels.
std::string_view series_dash(int series);

/// The value on a light page, "#0060ad"; "none" for none.
std::string_view light_value(Ink ink);

/// The value on a dark page.
std::string_view dark_value(Ink ink);

/// "blue", the last part of the names of classes and variables.
std::string_view ink_name(Ink ink);

/// The rules of a style sheet that colour all pictures of a page by variables `--ks-blue` and so
/// on. They do not name any colour; ink_variables does.
std::string ink_rules();

/// The declarations "--ks-blue:#0060ad;…" of a light or a dark page.
std::string light_variables();
std::string dark_variables();

}  // namespace kinestat
