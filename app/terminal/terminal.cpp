#include "terminal/terminal.hpp"

#include <cstdlib>
#include <sys/ioctl.h>
#include <unistd.h>

namespace kinestat::app {

namespace {

// https://no-color.org: set and not empty.
bool refuses_colors() {
  const char* const no = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  return (no != nullptr && *no != '\0') || terminal == nullptr ||
         std::string_view(terminal) == "dumb";
}

std::size_t width_of(int descriptor) {
  ::winsize size = {};
  return ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace

TextLayout layout_of(int descriptor, ColorChoice choice) {
  const bool is_terminal = ::isatty(descriptor) == 1;
  return {.width = is_terminal ? width_of(descriptor) : 0,
          .is_coloured = choice == ColorChoice::always ||
                         (choice == ColorChoice::automatic && is_terminal && !refuses_colors())};
}

}  // namespace kinestat::app
