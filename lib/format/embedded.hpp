// The texts inside the module; lib/format/CMakeLists.txt says which files they are.
#pragma once

#include "core/embedded_text.hpp"

namespace kinestat {

/// The part of the schema of mechanism files that is kept by hand: sections that are not declared
/// yet.
std::span<const EmbeddedText> embedded_kept_schema();

}  // namespace kinestat
