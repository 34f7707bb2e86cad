// Where the keys of a mapping stand.
#pragma once

#include <string_view>

#include "core/diagnostic.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Where a key of a mapping stands; the whole value if it is absent.
SourceRange place_of_key(const YamlNode& mapping, std::string_view key);

}  // namespace kinestat
