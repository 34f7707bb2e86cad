// Mechanisms of the library for the tests of this folder.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "files/load_file.hpp"

namespace kinestat {

/// The mechanism of a file below mechanisms/, without its gears as cases.
inline Mechanism library_mechanism(const std::string& name) {
  SourceFile source;
  Diagnostics found;
  const std::optional<Loaded> loaded =
      load(std::string(KINESTAT_SOURCE_DIR) + "/mechanisms/" + name, {}, source, found);
  if (!loaded) {
    throw std::runtime_error("cannot read " + name);
  }
  return loaded->mechanism;
}

}  // namespace kinestat
