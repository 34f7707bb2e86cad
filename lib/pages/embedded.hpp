// The texts inside the program; lib/CMakeLists.txt says which files they are.
#pragma once

#include "core/embedded_text.hpp"

namespace kinestat {

/// What a page needs beside its markup: "style", "script".
std::span<const EmbeddedText> embedded_page();

}  // namespace kinestat
