// The section `published`.
#pragma once

#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// In file order; wrong ones are left out, with errors.
std::vector<PublishedValue> read_published(const YamlNode& node, Diagnostics& found);

}  // namespace kinestat
