// How certain the answers of an analysis are, apart from their error bounds.
#pragma once

#include <optional>
#include <vector>

#include "core/accuracy.hpp"
#include "studies/mobility/rank_certainty.hpp"

namespace kinestat {

/// Whether motion and action of a case have an answer with the numbers as typed, but none once
/// these are rounded to double.
struct CaseCertainty {
  bool has_exact_input_motion = false;
  bool has_exact_input_action = false;
};

/// The certainty of the answers of an Analysis.
struct Certainty {
  AccuracyRequest accuracy;                  ///< as requested
  std::optional<RankCertainty> motion_rank;  ///< empty if Accuracy::fast was requested
  std::optional<RankCertainty> action_rank;  ///< also empty if actions are not counted
  std::vector<CaseCertainty> cases;          ///< of each case of the analysis
};

}  // namespace kinestat
