// The efficiency by the absolute model on the tape of a sweep.
#pragma once

#include <optional>
#include <span>

#include "cases/analysis.hpp"
#include "math/tapes/lane_recorder.hpp"

namespace kinestat {

/// Powers of a coupling without losses [W], as PowerFlow has them.
struct TapedPower {
  TapeNumber into_head;
  TapeNumber out_of_tail;
};

/// A case without losses on the tape.
struct TapedFlow {
  const Mechanism& mechanism;
  const CaseAnalysis& solved;             ///< with the parameters of the file
  std::span<const TapedPower> couplings;  ///< parallel to those of the topology
  std::span<const TapeNumber> actuators;  ///< likewise; powers [W]
  std::span<const TapeNumber> shares;     ///< that the lossy meshes lose
};

/// What find_absolute_efficiency finds where power goes the same ways as in the recorded state; a
/// lane in which it does not has no answer. Empty where the model has no answer there.
std::optional<TapeNumber> record_absolute_efficiency(const TapedFlow& flow, LaneRecorder& recorder);

}  // namespace kinestat
