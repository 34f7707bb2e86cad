#include "report/report_parts.hpp"

#include <fmt/format.h>

#include "core/utf8.hpp"

namespace kinestat {

std::string name_in_tables(const std::string& file, const MechanismDescription& description) {
  return description.name.empty() ? printable(file) : description.name;
}

std::string title_text(const std::string& file, const MechanismDescription& description) {
  const std::string name = printable(description.name.empty() ? file : description.name);
  return description.source.empty() ? name + "\n"
                                    : fmt::format("{} ({})\n", name, printable(description.source));
}

std::string_view in_drawn_position(const MechanismDescription& description) {
  return description.motion || description.simulation ? ", in the drawn position" : "";
}

}  // namespace kinestat
