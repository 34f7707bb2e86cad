// The texts inside the program; lib/CMakeLists.txt says which files they are.
#pragma once

#include "core/embedded_text.hpp"

namespace kinestat {

/// Commented mechanism files to begin with, named by their kind.
std::span<const EmbeddedText> embedded_starters();

/// The mechanism files of mechanisms/, as "planar/four_bar".
std::span<const EmbeddedText> embedded_library();

/// A small mechanism file for each type of coupling, named by its word.
std::span<const EmbeddedText> embedded_couplings();

/// Pages of help; the first line of each is its title. A line "{{keys SECTION}}" stands for the
/// keys of a section of the format, "{{sections}}" for the sections, "{{types}}" for the types of
/// couplings, "{{units}}" for the units.
std::span<const EmbeddedText> embedded_topics();

/// Scripts that complete the words of a command line, named by their shell.
std::span<const EmbeddedText> embedded_completions();

/// An example for each diagnostic code, named by the code. A line begins with "- " if it stands in
/// the wrong version only, with "+ " if in the right one only, else with two spaces.
std::span<const EmbeddedText> embedded_examples();

}  // namespace kinestat
