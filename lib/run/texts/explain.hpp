// What a diagnostic code means.
#pragma once

#include <string>

#include "files/outcome.hpp"

namespace kinestat {

/// Title, paragraph and example of a code such as "E0312"; without a code, the list of all.
Outcome explain(const std::string& code);

}  // namespace kinestat
