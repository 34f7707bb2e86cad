#include "plot/picture_title.hpp"

#include <fmt/format.h>

namespace kinestat {

std::string picture_title(std::string_view what,
                          const std::string& file,
                          const MechanismDescription& description) {
  if (!description.name.empty()) {
    return fmt::format("{}: {}", what, description.name);
  }
  return fmt::format("{}: {}", what, file == "-" ? "<stdin>" : file);
}

std::string picture_title(std::string_view what, const Analysis& analysis) {
  return picture_title(what, analysis.file, analysis.description);
}

}  // namespace kinestat
