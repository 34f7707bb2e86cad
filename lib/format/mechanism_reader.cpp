#include "format/mechanism_reader.hpp"

#include <utility>

#include "description/cable_expansion.hpp"
#include "description/converter_expansion.hpp"
#include "description/gear_expansion.hpp"
#include "format/sections/sections.hpp"

namespace kinestat {

std::optional<MechanismDescription> read_mechanism(const YamlNode& root, Diagnostics& found) {
  MechanismDescription result;
  if (!file_sections().read_into(result, whole_file(root, found))) {
    return std::nullopt;
  }
  expand_converters(result);
  expand_gears(result);
  expand_cables(result);
  return result;
}

}  // namespace kinestat
