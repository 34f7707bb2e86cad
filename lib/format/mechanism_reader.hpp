// A mechanism file as a description.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Reads every section; complains about everything that is wrong in form. What meshes and cables
/// make is added to bodies and couplings. Empty iff an error was added.
std::optional<MechanismDescription> read_mechanism(const YamlNode& root, Diagnostics& found);

}  // namespace kinestat
