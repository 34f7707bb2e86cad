// The case that --case names.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "mechanism/cases/case.hpp"

namespace kinestat {

/// The case with this label; without a label the first. Null if the file has no cases. An unknown
/// label is an error (E0101).
const Case* choose_case(const std::vector<Case>& cases,
                        const std::string& label,
                        Diagnostics& found);

}  // namespace kinestat
