// What a tape of a sweep is recorded into: its inputs, its outputs and the arithmetic between them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "expression/expression_tape.hpp"
#include "math/tapes/lane_recorder.hpp"

namespace kinestat {

class SweepPlan;

/// A number that a state gives to the tape.
struct SweepInput {
  enum class From {
    axis,            ///< a parameter that is varied: `index` is its slot, `part` the axis
    parameter,       ///< one that follows from these; `index` is its slot
    motion,          ///< coordinate `part` of the unit screw of a freedom
    action,          ///< likewise of an action
    flank,           ///< likewise of an action on the other flanks of its teeth
    primary_motion,  ///< `part` of the motions of the case of that index in the file
    primary_action,  ///< likewise
    share            ///< that the lossy mesh of that index loses
  };

  From from = From::parameter;
  std::size_t index = 0;
  std::size_t part = 0;
  Dimension dimension = {};  ///< of a parameter

  friend bool operator==(const SweepInput&, const SweepInput&) = default;
};

/// What the parts of a tape are recorded into, one after the other.
struct SweepNotes {
  LaneRecorder recorder;
  std::vector<SweepInput> inputs;                  ///< of the recorder
  std::vector<std::optional<TapeQuantity>> slots;  ///< of each parameter; empty: no value
  std::vector<TapeNumber> outputs;

  /// The next input, of which the recorded state has that value.
  TapeNumber take(const SweepInput& input, double value, const TapeRange& range = {});

  /// Its place among the outputs.
  std::size_t add_output(TapeNumber number);
};

/// Notes with the parameters: inputs are those that are varied, and what follows from them by more
/// than a tape can do.
SweepNotes note_parameters(const SweepPlan& plan);

}  // namespace kinestat
