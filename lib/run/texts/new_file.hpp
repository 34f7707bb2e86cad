// A mechanism file from inside the program, given to the user.
#pragma once

#include <string>
#include <string_view>

#include "files/outcome.hpp"
#include "io/atomic_file.hpp"

namespace kinestat {

/// The text on standard output or, where there is a path, in that file, whole or not at all, with
/// the command that answers what the text asks. A present file is replaced only when forced.
void give_mechanism_file(std::string text,
                         const std::string& path,
                         Overwrite overwrite,
                         Outcome& outcome);

}  // namespace kinestat
