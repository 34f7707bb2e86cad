#include "files/parameter_names.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"

namespace kinestat {

std::vector<std::string> parameter_names(const MechanismDescription& description) {
  std::vector<std::string> names;
  for (const ParameterDescription& one : description.parameters) {
    names.push_back(one.name.text);
  }
  return names;
}

std::string parameter_hint(const std::string& name,
                           const MechanismDescription& description,
                           const std::string& value) {
  const std::vector<std::string> names = parameter_names(description);
  return names.empty()
             ? fmt::format("add 'parameters: {{{}}}' to the file and use '{}' in it",
                           printable(name + ": " + value),
                           printable(name))
             : guess_before(name, names, fmt::format("its parameters are {}", plain_list(names)));
}

}  // namespace kinestat
