// Text and numbers as they may stand in SVG and HTML.
#pragma once

#include <string>
#include <string_view>

namespace kinestat {

/// The text with & < > " ' escaped, fit for elements and quoted attributes of SVG and HTML. Tab and
/// line feed become spaces; what XML forbids, bytes that are no UTF-8 among it, becomes U+FFFD.
std::string escape_markup(std::string_view text);

/// A coordinate with at most two decimals, "12.5"; the same bytes in any locale. It must be finite.
std::string format_coordinate(double value);

/// The characters of a text, as code points; U+FFFD for bytes that are none.
std::u32string code_points(std::string_view text);

}  // namespace kinestat
