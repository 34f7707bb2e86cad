#include "files/file_names.hpp"

#include "files/load_file.hpp"
#include "files/parameter_names.hpp"

namespace kinestat {

FileNames names_of(const Loaded& loaded) {
  FileNames names{.parameters = parameter_names(loaded.description), .actuators = {}, .cases = {}};
  for (const ActuatorTopology& actuator : loaded.mechanism.topology.actuators) {
    names.actuators.push_back(actuator.name);
  }
  for (const Case& one : loaded.mechanism.cases) {
    names.cases.push_back(one.label);
  }
  return names;
}

FileNames names_in_file(const std::string& path) {
  SourceFile source;
  Diagnostics found;
  const std::optional<Loaded> loaded = load(path, {}, source, found);
  return loaded ? names_of(*loaded) : FileNames{};
}

}  // namespace kinestat
