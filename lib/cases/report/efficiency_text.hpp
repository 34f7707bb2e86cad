// The efficiencies of a case with lossy meshes for people.
#pragma once

#include <string>

#include "cases/analysis.hpp"

namespace kinestat {

/// A line for each model, and a word on what tells them apart where the teeth do not roll. Empty
/// without lossy meshes.
std::string losses_text(const Mechanism& mechanism, const CaseAnalysis& one);

}  // namespace kinestat
