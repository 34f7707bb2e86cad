// A finished picture: what it shows in words, its size, and its elements.
#pragma once

#include <string>
#include <string_view>

#include "draw/svg.hpp"

namespace kinestat {

/// Stands before every id of a picture until it is embedded; escaped text never has it.
inline constexpr std::string_view kIdMark = "\x01";

/// Made by a function from solutions; a file or a part of a page is written of it. The title is not
/// among the elements: a file shows it above the picture, a page has it in its own words.
struct Picture {
  std::string name;         ///< "shift_matrix": fit for file names and ids
  std::string title;        ///< what it shows, as typed: not escaped
  std::string description;  ///< in words, for those who cannot see it
  PixelBox view;            ///< everything lies within
  std::string elements;     ///< of Svg::elements
};

/// A picture whose view box is what was drawn, with a margin [px].
Picture make_picture(std::string name,
                     std::string title,
                     std::string description,
                     const Svg& svg,
                     double margin = 12.0);

/// The whole file of a picture that stands alone, its title above it; light or dark as the reader
/// prefers, with a background. In programs that know no style sheets it is light.
std::string svg_file(const Picture& picture);

/// What the element `svg` of a page leaves to its style beside colours.
inline constexpr std::string_view kPictureRules =
    "figure svg{fill:var(--ks-ink)}"
    "figure svg :not(text,g,use,[class*=ks-f]){fill:none}"
    ".ks-r{stroke-linecap:round;stroke-linejoin:round}"
    "figure svg :is(text,g).ks-s-paper{stroke-width:3;stroke-linejoin:round;paint-order:stroke}";

/// How every such file begins.
std::string_view svg_signature();

/// The element `svg` for a page, without style: the page has ink_rules(), kPictureRules and the
/// variables. Ids begin with `prefix`, which must differ from those of other pictures on the page.
std::string svg_element(const Picture& picture, std::string_view prefix);

}  // namespace kinestat
