// What losses and power flow one case of a sweep asks of its tape.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cases/analysis.hpp"
#include "studies/sweep/network_tape.hpp"
#include "studies/sweep/task/sweep_notes.hpp"

namespace kinestat {

struct SweepTask;

/// The magnitudes of one side of a case that quantities, or the status of a row, need [SI].
struct TapedSide {
  std::vector<int> wanted;  ///< freedoms or actions, ascending
  TapedNetwork network;

  TapeNumber number(int index) const;
};

/// A case with the losses of its meshes left out, and the equations of its actions.
struct TapedCase {
  const CaseAnalysis& solved;  ///< with the parameters of the file
  const TapedSide& motion;     ///< with the motions of bodies
  const TapedSide& action;
  const TapedSystem& equilibrium;
  std::span<const TapeNumber> shares;  ///< that lossy meshes lose
};

/// What is left by losses: outputs of the tape.
struct LossTape {
  std::vector<std::size_t> actuators;   ///< powers [W] of all actuators
  std::size_t imbalance = 0;            ///< of these and the losses, which sum to zero
  std::optional<std::size_t> absolute;  ///< efficiency, where that model counts; then also:
  std::vector<std::size_t> lossless;    ///< the powers of actuators without losses
};

/// Where the power goes: outputs of the tape.
struct PowerTape {
  std::optional<LossTape> losses;      ///< where meshes lose any
  std::optional<std::size_t> largest;  ///< of the powers from shaft to shaft, where it is asked for
  std::size_t input = 0;               ///< beside `largest`: of the inputs, without losses
};

/// Beside the magnitudes without losses.
struct LossyTape {
  PowerTape power;
  std::optional<TapedSide> action;  ///< as the carrier model leaves them, where meshes lose any
};

/// Actions that the recorder of a case with power must know without losses.
std::vector<int> actions_with_power(const SweepTask& task);

/// Losses are recorded with the senses that they have in the recorded state; a lane in which a mesh
/// drives the other way round has no answer. Empty where no tape can be made: the case has
/// friction, or its efficiency has no value.
std::optional<LossyTape> note_power(const SweepTask& task,
                                    const TapedCase& taped,
                                    SweepNotes& notes);

}  // namespace kinestat
