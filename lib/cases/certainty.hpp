// What is known of the answers of an analysis beyond the bounds of their errors.
#pragma once

#include <optional>
#include <vector>

#include "core/accuracy.hpp"
#include "studies/mobility/rank_certainty.hpp"

namespace kinestat {

/// Sides of a case that have an answer as typed where they have none once rounded to double.
struct CaseCertainty {
  bool has_exact_input_motion = false;
  bool has_exact_input_action = false;
};

/// Beside an Analysis.
struct Certainty {
  AccuracyRequest accuracy;                  ///< what was asked for
  std::optional<RankCertainty> motion_rank;  ///< unless speed was asked for
  std::optional<RankCertainty> action_rank;  ///< likewise, where actions are counted
  std::vector<CaseCertainty> cases;          ///< of each case of the analysis
};

}  // namespace kinestat
