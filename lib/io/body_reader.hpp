// The section `bodies`.
#pragma once

#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// A list of names, or a mapping whose values may be empty. Wrong bodies are left out, with errors.
std::vector<BodyDescription> read_bodies(const YamlNode& node, Space space, Diagnostics& found);

}  // namespace kinestat
