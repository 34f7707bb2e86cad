// The answers to a synthesis task as tables for people.
#pragma once

#include <string>

#include "report/synthesis_report.hpp"

namespace kinestat {

std::string synthesis_text(const SynthesisAnalysis& analysis);

}  // namespace kinestat
