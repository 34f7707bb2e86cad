// What reports say of why an answer is believed.
#pragma once

#include "core/accuracy.hpp"
#include "math/elimination/rank.hpp"
#include "record/record.hpp"

namespace kinestat {

const Record<RankEvidence>& rank_evidence_record();

/// Of a system that was solved; `is_answered` is false where it has no answer.
struct EvidenceView {
  const RankEvidence& rank;
  const AnswerEvidence& answer;
  double residual = 0.0;  ///< relative
  bool is_answered = false;
};

const Record<EvidenceView>& evidence_record();

}  // namespace kinestat
