// What a synthesis has found, in sentences.
#pragma once

#include <string>
#include <vector>

#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// The task, its dyads and the best linkage; of a task with choices those of the first.
std::vector<std::string> synthesis_sentences(const SynthesisAnalysis& synthesis);

}  // namespace kinestat
