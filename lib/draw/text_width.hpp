// How wide a text is at most, without a font at hand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kinestat {

enum class Weight { normal, bold };

/// The fonts in which pictures are written; any of them may be there.
inline constexpr std::string_view kFontFamily =
    "Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif";

/// The width of a text in `kFontFamily` at a size, both in pixels: that of its widest font, so that
/// what is placed by it never overlaps.
double text_width(std::string_view text, double size, Weight weight = Weight::normal);

/// The text, or as much of its begin as fits the width, then "…".
std::string fitting_text(std::string_view text,
                         double size,
                         double width,
                         Weight weight = Weight::normal);

/// The text in lines of at most that width, broken at spaces; a longer word ends with "…".
std::vector<std::string> wrapped_text(std::string_view text,
                                      double size,
                                      double width,
                                      Weight weight = Weight::normal);

}  // namespace kinestat
