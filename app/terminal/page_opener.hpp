// Pages shown to the user.
#pragma once

#include <string>

namespace kinestat::app {

/// Has the desktop open a file in the program that shows pages, which goes on without this one.
/// Empty, or why it cannot be.
std::string open_page(const std::string& path);

/// Whether standard output is a terminal, on which a page would be of no use.
bool writes_to_terminal();

}  // namespace kinestat::app
