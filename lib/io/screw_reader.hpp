// Screws that are given directly.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/coupling_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Empty iff an error was added.
std::optional<ScrewDescription> read_screw(const YamlNode& node,
                                           std::string_view what,
                                           Space space,
                                           Diagnostics& found);

/// A list of screws; wrong ones are left out, with errors.
std::vector<ScrewDescription> read_screws(const YamlNode& node,
                                          std::string_view what,
                                          Space space,
                                          Diagnostics& found);

}  // namespace kinestat
