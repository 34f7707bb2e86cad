// The texts inside the program; lib/CMakeLists.txt says which files they are.
#pragma once

#include "core/embedded_text.hpp"

namespace kinestat {

/// "style", that of a page but for the palette of its pictures.
std::span<const EmbeddedText> embedded_style();

/// The parts of the script of a page, in their order.
std::span<const EmbeddedText> embedded_scripts();

}  // namespace kinestat
