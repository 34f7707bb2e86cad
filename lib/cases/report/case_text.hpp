// One case of an analysis for people.
#pragma once

#include <string>

#include "cases/analysis.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// The parts of the report of a case; those of passes that it did not ask for are empty.
struct CaseBlocks {
  std::string known;  ///< a line: the magnitudes that the case gives
  std::string ratio;  ///< a line: ratio and torque ratio, or why there is none
  TextBlocks motion;
  TextBlocks action;
  TextBlocks power;
  std::string affine;  ///< lines: the dependence on free parameters
};

CaseBlocks case_blocks(const Analysis& analysis, const CaseAnalysis& one);

/// All of it as text, below a line with the name of the case.
std::string case_text(const Analysis& analysis, const CaseAnalysis& one);

}  // namespace kinestat
