// What a diagnostic code means.
#pragma once

#include <string>
#include <string_view>

#include "files/outcome.hpp"

namespace kinestat {

/// Whether a word looks like a code, in upper or lower case.
bool is_code(std::string_view word);

/// Title, paragraph and example of a code such as "E0312"; without a code, the list of all.
Outcome explain(const std::string& code);

}  // namespace kinestat
