// What one case of a sweep asks of its tape.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cases/solve_cases.hpp"
#include "mechanism/bind/rebind.hpp"
#include "studies/sweep/task/bound_numbers.hpp"
#include "studies/sweep/task/power_tape.hpp"
#include "studies/sweep/task/sweep_notes.hpp"

namespace kinestat {

struct SweepTask;

/// A column of rows that is an output of the tape, in the unit of the file.
struct TapedColumn {
  std::size_t column = 0;  ///< which quantity
  std::size_t cell = 0;
};

/// By cells of outputs; while the tape is recorded, by their places among the outputs.
struct CaseTape {
  double known = 0.0;  ///< largest_known in the recorded state
  std::vector<TapedColumn> columns;
  std::vector<std::size_t> input_rates;  ///< [SI] of each input of the case, where needed
  std::vector<std::size_t> output_rates;
  std::vector<std::size_t> input_actions;
  std::vector<std::size_t> output_actions;
  /// Tensions and forces of contacts [SI]: where one is negative, the whole analysis judges.
  std::vector<std::size_t> one_sided;
  std::optional<PowerTape> power;   ///< where a quantity asks for it
  bool has_ratios = false;          ///< and a quantity asks for them
  std::vector<TapedColumn> ratios;  ///< where one input drives: right if they are finite
  double ratio_unit = 1.0;          ///< of the output's rate [SI], over:
  double ratio_per = 1.0;           ///< that of the input's
  double torque_ratio_unit = 1.0;   ///< likewise of actions
  double torque_ratio_per = 1.0;
};

/// What cases share.
struct SweptNumbers {
  const Rebinder* rebinder = nullptr;  ///< null: `bound` says what moves
  const BoundNumbers* bound = nullptr;
  const TapedScrews* screws = nullptr;
  std::span<const Geometry> samples;   ///< of some states
  std::span<const TapeNumber> shares;  ///< of each lossy mesh
  bool keeps_axes = false;             ///< of gears: they stay the lines that they are
};

/// Records the case of that place in the task, of which `solved` is the answer with the parameters
/// of the file. Empty where no tape can be made of it.
std::optional<CaseTape> note_case(const SweepTask& task,
                                  std::size_t place,
                                  const CaseAnalysis& solved,
                                  const SweptNumbers& numbers,
                                  SweepNotes& notes);

/// Puts cells in place of the outputs.
void find_cells(const LaneTape& tape, CaseTape& taped);

}  // namespace kinestat
