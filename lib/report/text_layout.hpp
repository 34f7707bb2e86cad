// How texts for people are laid out for what shows them.
#pragma once

#include <cstddef>

namespace kinestat {

struct TextLayout {
  std::size_t width = 0;     ///< columns of a terminal; 0: lines and tables are as long as they are
  bool is_coloured = false;  ///< marked by the escape sequences of a terminal (ECMA-48)
};

}  // namespace kinestat
