// The case that --case names.
#pragma once

#include <span>
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

/// Complains of --case: there is no case with this label (E0101). `labels` are those of the file.
void refuse_case(const std::string& label, std::span<const std::string> labels, Diagnostics& found);

}  // namespace kinestat
