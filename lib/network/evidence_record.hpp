// What reports say about the evidence for an answer: rank, residual and error bound.
#pragma once

#include "core/accuracy.hpp"
#include "math/elimination/rank.hpp"
#include "record/record.hpp"

namespace kinestat {

const Record<RankEvidence>& rank_evidence_record();

/// The evidence for the solution of a system.
struct EvidenceView {
  const RankEvidence& rank;
  const AnswerEvidence& answer;
  double residual = 0.0;     ///< relative
  bool is_answered = false;  ///< whether the system has a solution
};

const Record<EvidenceView>& evidence_record();

}  // namespace kinestat
