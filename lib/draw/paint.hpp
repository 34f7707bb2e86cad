// How shapes and texts are painted.
#pragma once

#include <string>

#include "draw/palette.hpp"
#include "draw/text_width.hpp"

namespace kinestat {

/// How a shape is painted.
struct Paint {
  Ink stroke = Ink::ink;
  Ink fill = Ink::none;
  double width = 1.5;       ///< of the stroke [px]
  std::string dash = {};    ///< dashes and gaps [px]; empty: full
  double opacity = 1.0;     ///< of the fill
  bool round_ends = false;  ///< round caps and joins, else flat caps and mitres
};

enum class Anchor { start, middle, end };

struct TextStyle {
  Ink ink = Ink::ink;
  double size = 12.0;  ///< [px]
  Weight weight = Weight::normal;
  Anchor anchor = Anchor::start;
  double turn = 0.0;       ///< about the place, clockwise [degrees]
  bool has_halo = false;   ///< a rim of paper around the letters, for text upon lines
  bool is_italic = false;  ///< for symbols of magnitudes
};

}  // namespace kinestat
