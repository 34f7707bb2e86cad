// The section `couplings`.
#pragma once

#include <vector>

#include "core/diagnostic.hpp"
#include "description/coupling_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// In file order; wrong ones are left out, with errors. Which keys may stand depends on the type;
/// which of them a type needs is checked when the mechanism is bound.
std::vector<CouplingDescription> read_couplings(const YamlNode& node,
                                                Space space,
                                                Diagnostics& found);

}  // namespace kinestat
