// The section `cases`.
#pragma once

#include <vector>

#include "core/diagnostic.hpp"
#include "description/case_description.hpp"
#include "description/coupling_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// In file order; wrong parts are left out, with errors.
std::vector<CaseDescription> read_cases(const YamlNode& node, Space space, Diagnostics& found);

}  // namespace kinestat
