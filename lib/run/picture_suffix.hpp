// What the name of a picture's file promises.
#pragma once

#include <string>

#include "files/outcome.hpp"

namespace kinestat {

/// Complains about a name that promises what is not written, as f.png; it says what makes that.
bool check_picture_suffix(const std::string& file, Outcome& outcome);

}  // namespace kinestat
